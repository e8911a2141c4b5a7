#include "engine/framing.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kinescope {

float Bounds::radius() const {
  return empty ? 0.0f : static_cast<float>(glm::length(glm::dvec3(max) - glm::dvec3(min)) * 0.5);
}

void Bounds::add(glm::vec3 point) {
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return;
  min = empty ? point : glm::min(min, point);
  max = empty ? point : glm::max(max, point);
  empty = false;
}

void Bounds::add(const Bounds& other) {
  if (other.empty) return;
  add(other.min);
  add(other.max);
}

}  // namespace kinescope
