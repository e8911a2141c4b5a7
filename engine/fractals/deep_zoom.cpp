#include "engine/fractals/deep_zoom.h"

#include <cmath>

#include "raster/base/error.h"
#include "raster/base/workers.h"

namespace kinescope {
namespace {

double square(const glm::dvec2& z) { return z.x * z.x + z.y * z.y; }

/// |z + apart| > 2 by |z|^2 - 4 + 2 z apart + |apart|^2: in the sum z + apart a small difference
/// would be lost.
bool escaped(const OrbitPoint& point, const glm::dvec2& apart) {
  const double linear = point.excess + 2.0 * (point.z.x * apart.x + point.z.y * apart.y);
  // The square may underflow, but is not 0.
  if (linear == 0.0) return apart != glm::dvec2(0.0);
  return !(linear + square(apart) <= 0.0);
}

}  // namespace

int deep_precision_bits(const DeepView& view) {
  if (!(view.step >= 1e-280 && view.step <= 1.0)) {
    throw_bad_input("a pixel of a deep view is 1e-280 to 1 wide");
  }
  return 64 + static_cast<int>(std::ceil(-std::log2(view.step)));
}

int perturbed_escape_time(const std::vector<OrbitPoint>& orbit, const glm::dvec2& offset,
                          int most) {
  glm::dvec2 apart(0.0);  // of the point from the orbit
  std::size_t at = 0;
  for (int n = 0; n < most; ++n) {
    const glm::dvec2 z = orbit[at].z + apart;
    const double size = square(z);
    if (!(size < 3.99) && escaped(orbit[at], apart)) return n;
    if (size < square(apart) || at + 1 == orbit.size()) {
      apart = z;
      at = 0;
    }
    const glm::dvec2 sum = 2.0 * orbit[at].z + apart;
    apart = {sum.x * apart.x - sum.y * apart.y + offset.x,
             sum.x * apart.y + sum.y * apart.x + offset.y};
    ++at;
  }
  return most;
}

std::vector<std::int32_t> deep_escape_times(const DeepView& view, Workers& workers) {
  if (view.width <= 0 || view.height <= 0 || view.width > (1 << 26) / view.height) {
    throw_bad_input("a picture of an escape-time fractal has 1 to 2^26 pixels");
  }
  const std::vector<OrbitPoint> orbit = reference_orbit(view);
  const auto width = static_cast<std::size_t>(view.width);
  std::vector<std::int32_t> times(width * static_cast<std::size_t>(view.height));
  workers.run(view.height, [&](int j, int) {
    std::int32_t* row = times.data() + width * static_cast<std::size_t>(j);
    for (int i = 0; i < view.width; ++i) {
      row[i] = perturbed_escape_time(orbit, view.offset(i, j), view.most);
    }
  });
  return times;
}

}  // namespace kinescope
