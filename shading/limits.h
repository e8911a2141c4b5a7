// Where the lighting formulas would divide by zero, and what they do instead; the scalar law and
// the kernels share these.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace kinescope {

inline constexpr float kLeastSquaredLength = 1e-30f;  ///< shorter vectors have no direction
inline constexpr float kLeastAttenuation = 1e-6f;     ///< of the divisor x + y d + z d^2
inline constexpr float kLeastCone = 1e-6f;            ///< of cos inner - cos outer
/// A highlight below this is none: most of a surface then needs no power. 2^-20.
inline constexpr float kLeastHighlightLog2 = -20.0f;

/// Unit length, or zero where there is no direction.
inline glm::vec3 normalized(glm::vec3 v) {
  const float squared = glm::dot(v, v);
  return squared > kLeastSquaredLength ? v / glm::sqrt(squared) : glm::vec3(0.0f);
}

}  // namespace kinescope
