// Light sources.
#pragma once

#include <glm/vec3.hpp>

namespace kinescope {

enum class LightKind { kDirectional, kPoint, kSpot };

/// One source, in world space; colour is linear and may exceed 1.
struct Light {
  LightKind kind = LightKind::kPoint;
  glm::vec3 colour{1.0f};
  glm::vec3 position{0.0f};                ///< point and spot
  glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< directional and spot: the way the light travels
  float inner_cone_rad = 0.0f;             ///< spot: full light within this half angle
  float outer_cone_rad = 0.785398f;        ///< spot: none beyond this half angle
  /// Attenuation 1 / (x + y d + z d^2) at distance d; (1, 0, 0) keeps the light constant.
  glm::vec3 attenuation{1.0f, 0.0f, 0.0f};
};

}  // namespace kinescope
