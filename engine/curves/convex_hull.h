// Convex hulls of points in the plane, and how often a line meets a polygon's sides.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace kinescope {

/// The hull's corners, counter-clockwise from the leftmost, none between two others; points that
/// are not finite are passed over. Source: Andrew, "Another Efficient Algorithm for Convex Hulls in
/// Two Dimensions", 1979.
std::vector<glm::dvec2> convex_hull(std::span<const glm::dvec2> points);

/// Whether p lies in the hull or on its side.
bool hull_contains(std::span<const glm::dvec2> hull, const glm::dvec2& p);

/// How often the chain of segments passes from one side of the line a-b to the other. A curve meets
/// no line more often than its control polygon does: the variation diminishing property.
int line_crossings(std::span<const glm::dvec2> chain, const glm::dvec2& a, const glm::dvec2& b);

}  // namespace kinescope
