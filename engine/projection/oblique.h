// Oblique projection: what faces the viewer keeps its shape, depth recedes at an angle. A shear.
// Source: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and Practice", 1990,
// ch. 6.1.
#pragma once

#include <glm/mat4x4.hpp>

namespace kinescope {

struct Oblique {
  double depth_scale = 1.0;    ///< length in the picture of a unit along -z, away from the viewer
  double receding_deg = 45.0;  ///< where it points, from the picture's x axis
};
inline constexpr double kCavalierDepth = 1.0;  ///< depth in full: projectors at 45 degrees
inline constexpr double kCabinetDepth = 0.5;   ///< depth halved: projectors at atan 2

/// Picture space: x right, y up, z towards the viewer.
glm::dmat4 picture_from_world(const Oblique& view);

/// Angle between the projectors and the picture plane. 90 degrees is orthographic.
double projector_angle_deg(const Oblique& view);

}  // namespace kinescope
