// Line segments cut by planes in homogeneous coordinates.
#pragma once

#include <glm/vec4.hpp>
#include <span>

#include "engine/clip_homogeneous.h"

namespace kinescope {

/// Cuts the segment a-b down to what lies inside all planes; false if nothing does, or if an end
/// is not finite. Each plane narrows the parameter's interval.
/// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", 1984, with the
/// distances of Blinn and Newell, "Clipping Using Homogeneous Coordinates", 1978.
bool clip_line(std::span<const ClipPlane> planes, glm::dvec4& a, glm::dvec4& b);

}  // namespace kinescope
