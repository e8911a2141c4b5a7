// Polygons of one or more contours, and their edges.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace kinescope {

/// Corners in pixels, y downwards; pixel (x, y) covers [x, x + 1) x [y, y + 1). The last corner
/// joins the first.
using Contour = std::vector<glm::dvec2>;

/// Contours may cross themselves and each other; a hole is a contour within another (one that turns
/// the other way, where windings count).
using Polygon = std::vector<Contour>;

/// Calls sink(from, to) for each edge. A corner that is not finite is passed over, so that what is
/// left still closes.
template <typename Sink>
void contour_edges(std::span<const glm::dvec2> contour, Sink&& sink) {
  const glm::dvec2 *first = nullptr, *before = nullptr;
  for (const glm::dvec2& corner : contour) {
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) continue;
    if (before) sink(*before, corner);
    if (!first) first = &corner;
    before = &corner;
  }
  if (before != first) sink(*before, *first);
}

}  // namespace kinescope
