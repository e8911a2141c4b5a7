#include "engine/fractals/dimension.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "raster/base/error.h"

namespace kinescope {

DimensionFit fit_dimension(std::span<const Covering> coverings) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (const Covering& c : coverings) {
    if (!(c.size > 0.0 && c.count > 0.0)) continue;
    const double x = -std::log(c.size), y = std::log(c.count);
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  const double xx = n * sxx - sx * sx, xy = n * sxy - sx * sy, yy = n * syy - sy * sy;
  if (n < 2 || !(xx > 0.0)) return {};
  return {xy / xx, yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0};
}

std::vector<Covering> count_boxes(std::span<const glm::dvec2> points,
                                  std::span<const double> sizes) {
  std::vector<Covering> coverings;
  std::vector<std::pair<std::int64_t, std::int64_t>> boxes;
  for (const double size : sizes) {
    boxes.clear();
    for (const glm::dvec2& p : points) {
      const double x = std::floor(p.x / size), y = std::floor(p.y / size);
      if (!(std::abs(x) < 9e18 && std::abs(y) < 9e18)) continue;
      boxes.emplace_back(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
    }
    std::sort(boxes.begin(), boxes.end());
    const auto end = std::unique(boxes.begin(), boxes.end());
    coverings.push_back({size, static_cast<double>(end - boxes.begin())});
  }
  return coverings;
}

RulerWalk walk_coast(std::span<const glm::dvec2> coast, double ruler) {
  if (!(ruler > 0.0)) throw_bad_input("a ruler has a length above 0");
  RulerWalk walk{ruler, 0.0, 0.0, {}};
  if (coast.empty()) return walk;
  glm::dvec2 foot = coast[0];
  walk.feet.push_back(foot);
  for (std::size_t i = 0; i + 1 < coast.size();) {
    const glm::dvec2 to = coast[i + 1];
    if (!(glm::distance(foot, to) > ruler)) {
      ++i;
      continue;
    }
    // Where this segment leaves the circle: the larger root. It begins inside, or at the foot.
    const glm::dvec2 from =
        walk.feet.back() == foot && glm::distance(foot, coast[i]) <= ruler ? coast[i] : foot;
    const glm::dvec2 d = to - from, e = from - foot;
    const double a = glm::dot(d, d), b = glm::dot(d, e), c = glm::dot(e, e) - ruler * ruler;
    const double t = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
    foot = from + t * d;
    walk.feet.push_back(foot);
    walk.steps += 1.0;
    if (walk.steps > 1e7) throw_bad_input("the ruler is too short for this coast");
  }
  walk.steps += glm::distance(foot, coast.back()) / ruler;
  walk.length = walk.steps * ruler;
  return walk;
}

}  // namespace kinescope
