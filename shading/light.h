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

/// What arrives at a point from one source.
struct Incident {
  glm::vec3 to_light{0.0f};  ///< unit length; zero if the point is the source itself
  glm::vec3 colour{0.0f};    ///< after attenuation and cone
};

/// The light of `light` at `position`. Between the cones of a spot it falls by the smoothstep law
/// t^2 (3 - 2t) of t = (cos a - cos outer) / (cos inner - cos outer) for the angle a off its axis.
Incident incident_light(const Light& light, glm::vec3 position);

/// A light's constants as the lighting code uses them.
struct PreparedLight {
  explicit PreparedLight(const Light& light);

  LightKind kind;
  bool attenuated;
  glm::vec3 colour;
  glm::vec3 position;
  glm::vec3 direction;  ///< unit length, the way the light travels
  glm::vec3 attenuation;
  float cos_outer = 0.0f;   ///< of a spot
  float cone_scale = 0.0f;  ///< of a spot: 1 / (cos inner - cos outer)
};

}  // namespace kinescope
