#include "engine/projection/axonometric.h"

#include <cmath>
#include <numbers>

#include "engine/transform/transform3d.h"
#include "raster/base/error.h"

namespace kinescope {

Axonometric isometric() { return dimetric(std::sqrt(2.0 / 3.0)); }

Axonometric dimetric(double z_foreshortening) {
  const double f = z_foreshortening * z_foreshortening;
  if (!(z_foreshortening >= 0.0 && f <= 1.0)) {
    throw_bad_input("an axis is foreshortened by 0 to 1");
  }
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  // Turned so that x and z both come towards the viewer.
  return {-kDegrees * std::asin(std::sqrt(f / (2.0 - f))),
          kDegrees * std::asin(std::sqrt(f / 2.0))};
}

glm::dmat4 picture_from_world(const Axonometric& view) {
  return rotation_x_deg(view.tilt_deg) * rotation_y_deg(view.turn_deg);
}

glm::dvec3 foreshortening(const glm::dmat4& picture_from_world) {
  const auto length = [&](int axis) {
    return std::hypot(picture_from_world[axis].x, picture_from_world[axis].y);
  };
  return {length(0), length(1), length(2)};
}

AxonometricKind axonometric_kind(const Axonometric& view, double tolerance) {
  const glm::dvec3 f = foreshortening(picture_from_world(view));
  const auto equal = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
  const int pairs = equal(f.x, f.y) + equal(f.y, f.z) + equal(f.z, f.x);
  if (pairs >= 2) return AxonometricKind::kIsometric;
  return pairs == 1 ? AxonometricKind::kDimetric : AxonometricKind::kTrimetric;
}

}  // namespace kinescope
