// Perspective with one, two and three vanishing points, and where those lie.
// Source: Rogers and Adams, "Mathematical Elements for Computer Graphics", 1990, ch. 3.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace kinescope {

/// The object turned as for an axonometric view and moved; the eye is on the z axis, the picture
/// plane z = 0. An axis has a vanishing point unless it stays parallel to that plane.
struct PerspectiveView {
  double eye_distance = 5.0;  ///< of the eye in front of the picture plane
  double turn_deg = 0.0;      ///< about y: x gets a vanishing point too
  double tilt_deg = 0.0;      ///< about x: y gets one
  glm::dvec3 moved_by{0.0};   ///< after turning
};

/// Homogeneous picture space, after the division by w: x right, y up; z keeps the order of depth.
/// What lies in the plane z = 0 keeps its size.
/// @throws Error (bad input) unless the eye's distance is positive and finite
glm::dmat4 picture_from_world(const PerspectiveView& view);

/// Where the pictures of all lines of a direction meet; none where they stay parallel.
std::optional<glm::dvec2> vanishing_point(const glm::dmat4& picture_from_world,
                                          const glm::dvec3& direction);

/// Those of x, y and z.
std::array<std::optional<glm::dvec2>, 3> principal_vanishing_points(
    const glm::dmat4& picture_from_world);

}  // namespace kinescope
