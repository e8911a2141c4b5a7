#include "raster/scan/conic_scan.h"

#include <cmath>
#include <utility>

#include "raster/scan/limits.h"

namespace kinescope {
namespace {

int nearest(double v) { return static_cast<int>(std::floor(v + 0.5)); }

/// The roots of p t^2 + q t + r, without the difference of nearly equal numbers.
std::pair<double, double> roots(double p, double q, double r) {
  const double nan = std::nan("");
  if (p == 0) return {q != 0 ? -r / q : nan, nan};
  const double under = q * q - 4 * p * r;
  if (!(under >= 0)) return {nan, nan};
  const double sum = -(q + std::copysign(std::sqrt(under), q)) / 2;
  return {sum / p, sum != 0 ? r / sum : nan};
}

}  // namespace

ConicScan::ConicScan(const Conic& conic, const PixelRect& window)
    : conic_(conic), window_(window), line_(window.x0 - 1) {
  const double sum = conic.a + conic.b + conic.c + conic.d + conic.e + conic.f;
  if (!std::isfinite(sum) || window.empty() || !is_drawable({window.x0, window.y0}) ||
      !is_drawable({window.x1, window.y1})) {
    window_ = {};
    line_ = -1;
  }
}

ConicScan::Crossings ConicScan::crossings(bool rows, int line) const {
  const Conic& k = conic_;
  const double t = line;
  const auto [first, second] = rows ? roots(k.a, k.b * t + k.d, (k.c * t + k.e) * t + k.f)
                                    : roots(k.c, k.b * t + k.e, (k.a * t + k.d) * t + k.f);
  const double low = rows ? window_.x0 : window_.y0, high = rows ? window_.x1 : window_.y1;
  Crossings found;
  for (const double along : {first, second}) {
    if (!(along >= low - 0.5 && along < high - 0.5)) continue;  // NaN too
    const double pixel = nearest(along);
    const glm::dvec2 g = rows ? k.gradient(pixel, t) : k.gradient(t, pixel);
    if (rows ? std::abs(g.x) <= std::abs(g.y) : std::abs(g.x) > std::abs(g.y)) continue;
    // Two branches in one pixel are one.
    if (found.count == 1 && nearest(found.along[0]) == nearest(along)) continue;
    found.along[static_cast<std::size_t>(found.count++)] = along;
  }
  return found;
}

bool ConicScan::next() {
  for (;;) {
    if (taken_ < found_.count) {
      const double along = found_.along[static_cast<std::size_t>(taken_++)], line = line_;
      point_ = by_rows_ ? glm::dvec2(along, line) : glm::dvec2(line, along);
      at_ = {nearest(point_.x), nearest(point_.y)};
      return true;
    }
    ++line_;
    if (!by_rows_ && line_ >= window_.x1) {
      by_rows_ = true;
      line_ = window_.y0;
    }
    if (by_rows_ && line_ >= window_.y1) return false;
    found_ = crossings(by_rows_, line_);
    taken_ = 0;
  }
}

}  // namespace kinescope
