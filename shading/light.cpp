#include "shading/light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/limits.h"

namespace kinescope {

PreparedLight::PreparedLight(const Light& light)
    : kind(light.kind),
      attenuated(light.attenuation != glm::vec3(1.0f, 0.0f, 0.0f)),
      colour(light.colour),
      position(light.position),
      direction(normalized(light.direction)),
      attenuation(light.attenuation) {
  if (kind != LightKind::kSpot) return;
  const float cos_inner = std::cos(std::min(light.inner_cone_rad, light.outer_cone_rad));
  cos_outer = std::cos(light.outer_cone_rad);
  cone_scale = 1.0f / std::max(cos_inner - cos_outer, kLeastCone);
}

Incident incident_light(const Light& light, glm::vec3 position) {
  const PreparedLight source(light);
  if (source.kind == LightKind::kDirectional) return {-source.direction, source.colour};
  const glm::vec3 way = source.position - position;
  const glm::vec3 to_light = normalized(way);
  float strength = 1.0f;
  if (source.attenuated) {
    const float distance = glm::length(way);
    const glm::vec3& k = source.attenuation;
    strength /= std::max(k.x + (k.y + k.z * distance) * distance, kLeastAttenuation);
  }
  if (source.kind == LightKind::kSpot) {
    const float off_axis = -glm::dot(to_light, source.direction) - source.cos_outer;
    const float t = std::clamp(off_axis * source.cone_scale, 0.0f, 1.0f);
    strength *= t * t * (3.0f - 2.0f * t);
  }
  return {to_light, source.colour * strength};
}

}  // namespace kinescope
