#include "engine/transform/plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "raster/base/error.h"

namespace kinescope {

double Plane::distance_to(const glm::dvec3& p) const {
  return glm::dot(unit_normal, p) - from_origin;
}

Plane plane_by_normal(const glm::dvec3& through, const glm::dvec3& normal) {
  const double length = std::hypot(normal.x, normal.y, normal.z);
  if (!(length > 0.0 && std::isfinite(length))) throw_bad_input("a plane needs a normal");
  const glm::dvec3 unit = normal / length;
  const double from_origin = glm::dot(unit, through);
  if (!std::isfinite(from_origin)) throw_bad_input("a plane needs a point that is finite");
  return {unit, from_origin};
}

Plane plane_by_points(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a;
  const glm::dvec3 normal = glm::cross(ab, ac);
  // Within rounding of one line there is no telling which way the plane leans.
  const double least = 1e-14 * glm::length(ab) * glm::length(ac);
  if (!(glm::length(normal) > least)) throw_bad_input("three points on one line span no plane");
  return plane_by_normal(a, normal);
}

glm::dvec3 mapped_normal(const glm::dmat4& affine, const glm::dvec3& normal) {
  // The cofactors are the inverse transpose times the determinant, which may be tiny or negative.
  const glm::dmat3 m(affine);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  const double determinant = glm::determinant(m);
  if (determinant == 0.0 || !std::isfinite(determinant)) {
    throw_bad_input("a map that flattens space leaves no normal");
  }
  const glm::dvec3 turned = cofactors * (determinant > 0.0 ? normal : -normal);
  return plane_by_normal(glm::dvec3(0.0), turned).unit_normal;
}

Plane mapped_plane(const glm::dmat4& affine, const Plane& plane) {
  const glm::dvec3 foot = plane.unit_normal * plane.from_origin;
  return plane_by_normal(glm::dvec3(affine * glm::dvec4(foot, 1.0)),
                         mapped_normal(affine, plane.unit_normal));
}

}  // namespace kinescope
