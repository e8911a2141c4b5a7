#include "engine/curves/convex_hull.h"

#include <algorithm>

#include "engine/clip/clip_window.h"
#include "engine/clip/orientation.h"

namespace kinescope {

std::vector<glm::dvec2> convex_hull(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> sorted;
  std::copy_if(points.begin(), points.end(), std::back_inserter(sorted), is_finite);
  std::sort(sorted.begin(), sorted.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;
  std::vector<glm::dvec2> hull;
  const auto walk = [&](auto from, auto to) {
    const std::size_t base = hull.size();
    for (auto p = from; p != to; ++p) {
      while (hull.size() >= base + 2 && orientation(hull[hull.size() - 2], hull.back(), *p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();  // the other chain begins with it
  };
  walk(sorted.begin(), sorted.end());
  walk(sorted.rbegin(), sorted.rend());
  return hull;
}

bool hull_contains(std::span<const glm::dvec2> hull, const glm::dvec2& p) {
  if (hull.empty()) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (orientation(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  }
  if (hull.size() > 2) return true;
  // A point or a segment has no sides: orientation told only the line.
  const auto [low_x, high_x] = std::minmax(hull.front().x, hull.back().x);
  const auto [low_y, high_y] = std::minmax(hull.front().y, hull.back().y);
  return p.x >= low_x && p.x <= high_x && p.y >= low_y && p.y <= high_y &&
         orientation(hull.front(), hull.back(), p) == 0;
}

int line_crossings(std::span<const glm::dvec2> chain, const glm::dvec2& a, const glm::dvec2& b) {
  int crossings = 0, last = 0;
  for (const glm::dvec2& p : chain) {
    const int side = orientation(a, b, p);
    if (side == 0) continue;
    if (last != 0 && side != last) ++crossings;
    last = side;
  }
  return crossings;
}

}  // namespace kinescope
