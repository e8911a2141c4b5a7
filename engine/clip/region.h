// Regions of the plane bounded by contours, for clippers that take holes.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace kinescope {

/// A closed contour: an edge joins the last corner to the first.
using Contour = std::vector<glm::dvec2>;
/// Inside by the even-odd rule: outer contours and holes, none of which cross.
using Region = std::vector<Contour>;

double signed_area(std::span<const glm::dvec2> contour);
/// By a ray to the right that counts each corner once.
bool contains(const Region& region, const glm::dvec2& p);

/// The region with what bounds nothing left out, and each contour turned so that the inside lies on
/// its left: holes run clockwise. @throws Error (bad input) for corners that are not finite
Region oriented(std::span<const Contour> contours);

}  // namespace kinescope
