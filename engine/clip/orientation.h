// On which side of a line a point lies, without rounding.
#pragma once

#include <glm/vec2.hpp>

namespace kinescope {

/// The sign of the triangle's area: 1 if a, b, c turn counter-clockwise, -1 clockwise, 0 if they
/// lie on one line. Exact for finite coordinates whose products neither overflow nor underflow.
/// Source: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates", 1997.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

}  // namespace kinescope
