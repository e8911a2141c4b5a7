#include "engine/fractals/dimension.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "raster/base/error.h"

namespace kinescope {

double moran_dimension(std::span<const double> ratios) {
  const auto sum = [&](double d) {
    double all = 0.0;
    for (const double ratio : ratios) all += std::pow(ratio, d);
    return all;
  };
  const auto bad = [](double ratio) { return !(ratio > 0.0 && ratio < 1.0); };
  if (ratios.size() < 2 || std::any_of(ratios.begin(), ratios.end(), bad)) return INFINITY;
  double low = 0.0, high = 1.0;  // the sum falls as d grows
  while (sum(high) > 1.0) high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (sum(middle) > 1.0 ? low : high) = middle;
  }
  return high;
}

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

double gyration_dimension(std::span<const glm::ivec2> particles) {
  if (particles.size() < 32) return 0.0;
  glm::dvec2 sum(0.0);
  double squares = 0.0;
  // Least squares of log radius over log N; large N lie close together there, and count for less.
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const glm::dvec2 p(particles[i]);
    const auto n = static_cast<double>(i + 1);
    sum += p;
    squares += glm::dot(p, p);
    if (i < particles.size() / 16) continue;
    const double size = std::log(n);
    const double radius = 0.5 * std::log(squares / n - glm::dot(sum, sum) / (n * n));
    w += 1 / n, x += size / n, y += radius / n, xx += size * size / n, xy += size * radius / n;
  }
  return (w * xx - x * x) / (w * xy - x * y);
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
