#include "engine/clip/region.h"

#include <algorithm>
#include <cmath>

#include "engine/clip/clip_window.h"
#include "engine/clip/orientation.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

bool ray_hits(std::span<const glm::dvec2> contour, const glm::dvec2& p) {
  bool odd = false;
  for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
    const glm::dvec2 &a = contour[j], &b = contour[i];
    if ((a.y > p.y) != (b.y > p.y) && (orientation(a, b, p) > 0) == (b.y > a.y)) odd = !odd;
  }
  return odd;
}

Contour without_repeats(const Contour& contour) {
  Contour kept;
  for (const glm::dvec2& p : contour) {
    if (!is_finite(p)) throw_bad_input("a polygon needs finite corners");
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

}  // namespace

double signed_area(std::span<const glm::dvec2> contour) {
  double twice = 0.0;
  for (std::size_t i = 2; i < contour.size(); ++i) {
    const glm::dvec2 a = contour[i - 1] - contour[0], b = contour[i] - contour[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

bool contains(const Region& region, const glm::dvec2& p) {
  bool odd = false;
  for (const Contour& contour : region) {
    if (contour.size() >= 3) odd ^= ray_hits(contour, p);
  }
  return odd;
}

Region oriented(std::span<const Contour> contours) {
  Region region;
  for (const Contour& contour : contours) {
    Contour kept = without_repeats(contour);
    if (kept.size() >= 3 && signed_area(kept) != 0.0) region.push_back(std::move(kept));
  }
  std::vector<bool> hole(region.size());
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (std::size_t j = 0; j < region.size(); ++j) {
      if (i != j && ray_hits(region[j], region[i][0])) hole[i] = !hole[i];
    }
  }
  for (std::size_t i = 0; i < region.size(); ++i) {
    if ((signed_area(region[i]) < 0.0) != hole[i]) {
      std::reverse(region[i].begin(), region[i].end());
    }
  }
  return region;
}

}  // namespace kinescope
