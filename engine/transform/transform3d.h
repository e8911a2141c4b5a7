// Three-dimensional transformations as matrices in homogeneous coordinates, for column vectors.
// Axes are right-handed; a positive angle is counter-clockwise seen from the axis's tip.
// Source: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and Practice", 1990,
// ch. 5.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/transform/plane.h"

namespace kinescope {

glm::dmat4 translation(const glm::dvec3& by);
glm::dmat4 scaling(const glm::dvec3& factors);
glm::dmat4 scaling_about(const glm::dvec3& fixed, const glm::dvec3& factors);
glm::dmat4 rotation_x_deg(double angle_deg);
glm::dmat4 rotation_y_deg(double angle_deg);
glm::dmat4 rotation_z_deg(double angle_deg);

/// A line in space: the axis of a rotation, or of a reflection.
struct Axis {
  glm::dvec3 through{0.0};
  glm::dvec3 direction{0.0, 0.0, 1.0};  ///< of any length but none
};
/// Rotation about any axis, by Rodrigues' formula. @throws Error (bad input) without a direction
glm::dmat4 rotation_about_deg(const Axis& axis, double angle_deg);

/// x' = x + a y + b z, y' = c x + y + d z, z' = e x + f y + z.
struct ShearFactors {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;
};
glm::dmat4 shear(const ShearFactors& factors);

glm::dmat4 reflection_in_plane(const Plane& plane);
/// The half turn about the axis: every point to the other side of it, as far.
glm::dmat4 reflection_about_axis(const Axis& axis);

/// The point where a matrix puts p, after the division by w.
glm::dvec3 apply(const glm::dmat4& matrix, const glm::dvec3& p);

/// As for two dimensions: the axes move, not the object. @throws Error (bad input) if singular
glm::dmat4 coordinate_from_geometric(const glm::dmat4& geometric);

/// One factor of a composed transformation, in the order of action.
struct TransformStep3 {
  std::string name;
  glm::dmat4 matrix;
};
/// The product, last step leftmost.
glm::dmat4 compose(std::span<const TransformStep3> steps);

/// The textbook's seven: axis through the origin, turned into the plane y = 0, onto z, the
/// rotation, and back again. Their product is rotation_about_deg.
std::vector<TransformStep3> rotation_about_steps(const Axis& axis, double angle_deg);
/// Plane through the origin, its normal onto z, the reflection in z = 0, and back again.
std::vector<TransformStep3> reflection_in_plane_steps(const Plane& plane);

}  // namespace kinescope
