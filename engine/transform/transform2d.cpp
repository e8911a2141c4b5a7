#include "engine/transform/transform2d.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/transform/exact_angle.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// Of rows as they are written on paper.
glm::dmat3 from_rows(const glm::dvec3& first, const glm::dvec3& second) {
  return glm::transpose(glm::dmat3(first, second, glm::dvec3(0, 0, 1)));
}

}  // namespace

glm::dmat3 translation(const glm::dvec2& by) { return from_rows({1, 0, by.x}, {0, 1, by.y}); }

glm::dmat3 scaling(double factor) { return scaling(glm::dvec2(factor)); }

glm::dmat3 scaling(const glm::dvec2& factors) {
  return from_rows({factors.x, 0, 0}, {0, factors.y, 0});
}

glm::dmat3 scaling_about(const glm::dvec2& fixed, const glm::dvec2& factors) {
  return translation(fixed) * scaling(factors) * translation(-fixed);
}

glm::dmat3 rotation_deg(double angle_deg) {
  const auto [s, c] = sine_cosine_deg(angle_deg);
  return from_rows({c, -s, 0}, {s, c, 0});
}

glm::dmat3 rotation_about_deg(const glm::dvec2& pivot, double angle_deg) {
  return translation(pivot) * rotation_deg(angle_deg) * translation(-pivot);
}

glm::dmat3 shear(double along_x, double along_y) {
  return from_rows({1, along_x, 0}, {along_y, 1, 0});
}

glm::dmat3 reflection_in_x_axis() { return scaling({1, -1}); }
glm::dmat3 reflection_in_y_axis() { return scaling({-1, 1}); }
glm::dmat3 reflection_in_origin() { return scaling(-1.0); }
glm::dmat3 reflection_in_diagonal() { return from_rows({0, 1, 0}, {1, 0, 0}); }

glm::dmat3 reflection_in_line(double slope, double intercept) {
  const double m = slope, c = intercept, n = 1.0 + m * m;
  return from_rows({(1 - m * m) / n, 2 * m / n, -2 * m * c / n},
                   {2 * m / n, (m * m - 1) / n, 2 * c / n});
}

glm::dmat3 reflection_in_line(const glm::dvec2& through, const glm::dvec2& direction) {
  const double length = std::hypot(direction.x, direction.y);
  if (!(length > 0.0 && std::isfinite(length))) {
    throw_bad_input("a line to reflect in needs a direction");
  }
  const glm::dvec2 d = direction / length;
  const double cos2 = d.x * d.x - d.y * d.y, sin2 = 2.0 * d.x * d.y;
  const glm::dmat3 turned = from_rows({cos2, sin2, 0}, {sin2, -cos2, 0});
  return translation(through) * turned * translation(-through);
}

glm::dvec2 apply(const glm::dmat3& matrix, const glm::dvec2& p) {
  const glm::dvec3 h = matrix * glm::dvec3(p, 1.0);
  return h.z == 1.0 ? glm::dvec2(h) : glm::dvec2(h) / h.z;
}

glm::dmat3 coordinate_from_geometric(const glm::dmat3& geometric) {
  const double determinant = glm::determinant(geometric);
  if (determinant == 0.0 || !std::isfinite(determinant)) {
    throw_bad_input("a transformation that flattens the plane has no inverse");
  }
  return glm::inverse(geometric);
}

glm::dmat3 compose(std::span<const TransformStep2> steps) {
  glm::dmat3 product(1.0);
  for (const TransformStep2& step : steps) product = step.matrix * product;
  return product;
}

std::vector<TransformStep2> about_steps(const glm::dvec2& fixed, const std::string& name,
                                        const glm::dmat3& matrix) {
  return {{"pivot to the origin", translation(-fixed)},
          {name, matrix},
          {"and back", translation(fixed)}};
}

std::vector<TransformStep2> rotation_about_steps(const glm::dvec2& pivot, double angle_deg) {
  return {{"pivot to the origin", translation(-pivot)},
          {"rotate", rotation_deg(angle_deg)},
          {"pivot back", translation(pivot)}};
}

std::vector<TransformStep2> scaling_about_steps(const glm::dvec2& fixed,
                                                const glm::dvec2& factors) {
  return {{"fixed point to the origin", translation(-fixed)},
          {"scale", scaling(factors)},
          {"fixed point back", translation(fixed)}};
}

std::vector<TransformStep2> reflection_in_line_steps(double slope, double intercept) {
  // cos and sin of the line's angle, without the angle.
  const double c = 1.0 / std::hypot(1.0, slope), s = slope * c;
  const glm::dmat3 forth = from_rows({c, -s, 0}, {s, c, 0});
  return {{"line through the origin", translation({0, -intercept})},
          {"line onto the x axis", glm::transpose(forth)},
          {"reflect in the x axis", reflection_in_x_axis()},
          {"line turned back", forth},
          {"line moved back", translation({0, intercept})}};
}

}  // namespace kinescope
