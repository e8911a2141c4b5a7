#include "engine/transform/transform3d.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "engine/transform/exact_angle.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// Of rows as they are written on paper.
glm::dmat4 from_rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z) {
  return glm::transpose(glm::dmat4(x, y, z, glm::dvec4(0, 0, 0, 1)));
}

glm::dvec3 unit_direction(const Axis& axis) {
  const glm::dvec3& d = axis.direction;
  const double length = std::hypot(d.x, d.y, d.z);
  if (!(length > 0.0 && std::isfinite(length))) throw_bad_input("an axis needs a direction");
  return d / length;
}

/// Rotations that carry a unit vector into the plane y = 0, then onto +z.
struct OntoZ {
  glm::dmat4 about_x, about_y;
};
OntoZ onto_z(const glm::dvec3& u) {
  const double d = std::hypot(u.y, u.z);
  const double c = d > 0.0 ? u.z / d : 1.0, s = d > 0.0 ? u.y / d : 0.0;
  return {from_rows({1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}),
          from_rows({d, 0, -u.x, 0}, {0, 1, 0, 0}, {u.x, 0, d, 0})};
}

glm::dmat4 about_direction(const glm::dvec3& u, double s, double c) {
  const double v = 1.0 - c;
  return from_rows({c + u.x * u.x * v, u.x * u.y * v - u.z * s, u.x * u.z * v + u.y * s, 0},
                   {u.y * u.x * v + u.z * s, c + u.y * u.y * v, u.y * u.z * v - u.x * s, 0},
                   {u.z * u.x * v - u.y * s, u.z * u.y * v + u.x * s, c + u.z * u.z * v, 0});
}

}  // namespace

glm::dmat4 translation(const glm::dvec3& by) {
  return from_rows({1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z});
}

glm::dmat4 scaling(const glm::dvec3& factors) {
  return from_rows({factors.x, 0, 0, 0}, {0, factors.y, 0, 0}, {0, 0, factors.z, 0});
}

glm::dmat4 scaling_about(const glm::dvec3& fixed, const glm::dvec3& factors) {
  return translation(fixed) * scaling(factors) * translation(-fixed);
}

glm::dmat4 rotation_x_deg(double angle_deg) {
  const auto [s, c] = sine_cosine_deg(angle_deg);
  return from_rows({1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0});
}

glm::dmat4 rotation_y_deg(double angle_deg) {
  const auto [s, c] = sine_cosine_deg(angle_deg);
  return from_rows({c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0});
}

glm::dmat4 rotation_z_deg(double angle_deg) {
  const auto [s, c] = sine_cosine_deg(angle_deg);
  return from_rows({c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0});
}

glm::dmat4 rotation_about_deg(const Axis& axis, double angle_deg) {
  const auto [s, c] = sine_cosine_deg(angle_deg);
  return translation(axis.through) * about_direction(unit_direction(axis), s, c) *
         translation(-axis.through);
}

glm::dmat4 shear(const ShearFactors& factors) {
  return from_rows({1, factors.a, factors.b, 0}, {factors.c, 1, factors.d, 0},
                   {factors.e, factors.f, 1, 0});
}

glm::dmat4 reflection_in_plane(const Plane& plane) {
  const glm::dvec3& n = plane.unit_normal;
  const double d = 2.0 * plane.from_origin;
  return from_rows({1 - 2 * n.x * n.x, -2 * n.x * n.y, -2 * n.x * n.z, d * n.x},
                   {-2 * n.y * n.x, 1 - 2 * n.y * n.y, -2 * n.y * n.z, d * n.y},
                   {-2 * n.z * n.x, -2 * n.z * n.y, 1 - 2 * n.z * n.z, d * n.z});
}

glm::dmat4 reflection_about_axis(const Axis& axis) {
  return translation(axis.through) * about_direction(unit_direction(axis), 0.0, -1.0) *
         translation(-axis.through);
}

glm::dvec3 apply(const glm::dmat4& matrix, const glm::dvec3& p) {
  const glm::dvec4 h = matrix * glm::dvec4(p, 1.0);
  return h.w == 1.0 ? glm::dvec3(h) : glm::dvec3(h) / h.w;
}

glm::dmat4 coordinate_from_geometric(const glm::dmat4& geometric) {
  const double determinant = glm::determinant(geometric);
  if (determinant == 0.0 || !std::isfinite(determinant)) {
    throw_bad_input("a transformation that flattens space has no inverse");
  }
  return glm::inverse(geometric);
}

glm::dmat4 compose(std::span<const TransformStep3> steps) {
  glm::dmat4 product(1.0);
  for (const TransformStep3& step : steps) product = step.matrix * product;
  return product;
}

std::vector<TransformStep3> rotation_about_steps(const Axis& axis, double angle_deg) {
  const auto [about_x, about_y] = onto_z(unit_direction(axis));
  return {{"axis through the origin", translation(-axis.through)},
          {"about x: axis into the plane y = 0", about_x},
          {"about y: axis onto z", about_y},
          {"rotate about z", rotation_z_deg(angle_deg)},
          {"about y, back", glm::transpose(about_y)},
          {"about x, back", glm::transpose(about_x)},
          {"axis moved back", translation(axis.through)}};
}

std::vector<TransformStep3> reflection_in_plane_steps(const Plane& plane) {
  const auto [about_x, about_y] = onto_z(plane.unit_normal);
  const glm::dvec3 foot = plane.unit_normal * plane.from_origin;
  return {{"plane through the origin", translation(-foot)},
          {"about x: normal into the plane y = 0", about_x},
          {"about y: normal onto z", about_y},
          {"reflect in z = 0", scaling({1, 1, -1})},
          {"about y, back", glm::transpose(about_y)},
          {"about x, back", glm::transpose(about_x)},
          {"plane moved back", translation(foot)}};
}

}  // namespace kinescope
