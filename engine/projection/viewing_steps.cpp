#include "engine/projection/viewing_steps.h"

#include <cmath>

#include "raster/base/error.h"

namespace kinescope {
namespace {

glm::dmat4 middle_onto_axis(const Camera& camera, const glm::dvec2& middle) {
  if (camera.projection == Projection::kOrthographic) return translation({-middle.x, -middle.y, 0});
  ShearFactors factors;  // x' = x + b z at z = -view_distance takes the middle away
  factors.b = middle.x / camera.view_distance;
  factors.d = middle.y / camera.view_distance;
  return shear(factors);
}

glm::dmat4 onto_canonical(const Camera& camera, const glm::dvec2& half) {
  const double far = std::isfinite(camera.far_plane) ? camera.far_plane : 1.0;
  if (camera.projection == Projection::kOrthographic) {
    return scaling({1.0 / half.x, 1.0 / half.y, 1.0 / far});
  }
  const double distance = camera.view_distance;
  return scaling({distance / (half.x * far), distance / (half.y * far), 1.0 / far});
}

}  // namespace

std::vector<TransformStep3> viewing_steps(const Camera& camera) {
  const glm::dvec2 low(camera.window_min), high(camera.window_max);
  const glm::dvec2 half = 0.5 * (high - low), middle = 0.5 * (high + low);
  if (!(half.x > 0.0 && half.y > 0.0 && camera.view_distance > 0.0f && camera.far_plane > 0.0f)) {
    throw_bad_input("a view volume has a width, a height and a depth");
  }
  glm::dmat4 turn(camera.view_from_world());
  turn[3] = {0, 0, 0, 1};
  return {{"eye to the origin", translation(-glm::dvec3(camera.eye))},
          {"line of sight onto -z, up onto y", turn},
          {"window's middle onto the axis", middle_onto_axis(camera, middle)},
          {"to the canonical volume", onto_canonical(camera, half)}};
}

}  // namespace kinescope
