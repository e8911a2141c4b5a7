// A part of a transformation, so that one can be watched as it happens.
#pragma once

#include <glm/mat4x4.hpp>

namespace kinescope {

/// `share` of the way from nothing to an affine matrix. Where its linear part is a rotation, it
/// turns evenly about its axis (of half turns, counter-clockwise); any other is blended: a
/// reflection flattens what it turns over. Translations go straight. 0 and 1 are exact.
glm::dmat4 in_between(const glm::dmat4& affine, double share);

}  // namespace kinescope
