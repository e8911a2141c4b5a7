// Axonometric projection: the object is turned about y, tilted about x, and seen from +z.
// Source: Rogers and Adams, "Mathematical Elements for Computer Graphics", 1990, ch. 3.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace kinescope {

struct Axonometric {
  double turn_deg = 0.0;  ///< about y, first
  double tilt_deg = 0.0;  ///< about x, then
};

/// All three axes foreshortened alike, by sqrt(2/3), 120 degrees apart.
Axonometric isometric();
/// z foreshortened as given, x and y alike.
/// @throws Error (bad input) unless the factor lies within 0 and 1
Axonometric dimetric(double z_foreshortening);
// Any other two angles are trimetric.

/// Picture space: x right, y up, z towards the viewer.
glm::dmat4 picture_from_world(const Axonometric& view);

/// Length in the picture of a unit along x, y and z. Their squares add up to 2.
glm::dvec3 foreshortening(const glm::dmat4& picture_from_world);

enum class AxonometricKind { kIsometric, kDimetric, kTrimetric };
/// By how many of the three factors are equal, to within `tolerance`.
AxonometricKind axonometric_kind(const Axonometric& view, double tolerance = 1e-9);

}  // namespace kinescope
