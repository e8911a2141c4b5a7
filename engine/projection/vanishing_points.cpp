#include "engine/projection/vanishing_points.h"

#include <cmath>
#include <glm/vec4.hpp>

#include "engine/transform/transform3d.h"
#include "raster/base/error.h"

namespace kinescope {

glm::dmat4 picture_from_world(const PerspectiveView& view) {
  if (!(view.eye_distance > 0.0 && std::isfinite(view.eye_distance))) {
    throw_bad_input("the eye stands before the picture plane");
  }
  glm::dmat4 perspective(1.0);
  perspective[2][3] = -1.0 / view.eye_distance;  // w = 1 - z / distance
  return perspective * translation(view.moved_by) * rotation_x_deg(view.tilt_deg) *
         rotation_y_deg(view.turn_deg);
}

std::optional<glm::dvec2> vanishing_point(const glm::dmat4& picture_from_world,
                                          const glm::dvec3& direction) {
  // The point at infinity in that direction has a picture like any other.
  const glm::dvec4 h = picture_from_world * glm::dvec4(direction, 0.0);
  if (h.w == 0.0) return std::nullopt;
  return glm::dvec2(h.x, h.y) / h.w;
}

std::array<std::optional<glm::dvec2>, 3> principal_vanishing_points(
    const glm::dmat4& picture_from_world) {
  return {vanishing_point(picture_from_world, {1, 0, 0}),
          vanishing_point(picture_from_world, {0, 1, 0}),
          vanishing_point(picture_from_world, {0, 0, 1})};
}

}  // namespace kinescope
