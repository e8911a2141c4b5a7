// Planes and normals, and what affine maps make of them.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace kinescope {

/// Points p with dot(unit_normal, p) = from_origin.
struct Plane {
  glm::dvec3 unit_normal{0.0, 0.0, 1.0};
  double from_origin = 0.0;

  /// Signed distance, positive on the normal's side.
  double distance_to(const glm::dvec3& p) const;
};

/// @throws Error (bad input) if the normal has no length
Plane plane_by_normal(const glm::dvec3& through, const glm::dvec3& normal);
/// The normal points to where a, b, c run counter-clockwise.
/// @throws Error (bad input) if the points lie on one line
Plane plane_by_points(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The unit normal of a surface after an affine map: by the inverse transpose of the linear part,
/// so that it stays square to the mapped tangents. @throws Error (bad input) if the map is singular
glm::dvec3 mapped_normal(const glm::dmat4& affine, const glm::dvec3& normal);
/// The plane of the mapped points.
Plane mapped_plane(const glm::dmat4& affine, const Plane& plane);

}  // namespace kinescope
