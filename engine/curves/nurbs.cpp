#include "engine/curves/nurbs.h"

#include <array>
#include <numbers>

#include "raster/base/error.h"

namespace kinescope {

NurbsCurve nurbs_curve(int order, std::span<const glm::dvec2> control,
                       std::span<const double> weights, std::vector<double> knots) {
  if (control.size() != weights.size()) throw_bad_input("each control point needs one weight");
  NurbsCurve curve{order, {}, std::move(knots)};
  for (std::size_t i = 0; i < control.size(); ++i) {
    if (!(weights[i] > 0.0)) throw_bad_input("a control point's weight is above 0");
    curve.control.emplace_back(weights[i] * control[i], weights[i]);
  }
  check_knots(curve.order, curve.controls(), curve.knots);
  return curve;
}

glm::dvec2 nurbs_point(const NurbsCurve& curve, double t) {
  const glm::dvec3 p = b_spline_point(curve, t);
  return glm::dvec2(p) / p.z;
}

std::vector<double> rational_basis(const NurbsCurve& curve, double t) {
  std::vector<double> shares;
  double sum = 0.0;
  for (int i = 0; i < curve.controls(); ++i) {
    shares.push_back(curve.control[static_cast<std::size_t>(i)].z *
                     b_spline_basis(i, curve.order, curve.knots, t));
    sum += shares.back();
  }
  if (!(sum > 0.0)) return {};
  for (double& share : shares) share /= sum;
  return shares;
}

NurbsCurve nurbs_circle(const glm::dvec2& centre, double radius) {
  constexpr std::array<glm::dvec2, 9> kSquare = {
      glm::dvec2(1, 0), {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  std::array<glm::dvec2, 9> control;
  std::array<double, 9> weights;
  for (std::size_t i = 0; i < 9; ++i) {
    control[i] = centre + radius * kSquare[i];
    weights[i] = i % 2 == 0 ? 1.0 : std::numbers::sqrt2 / 2;
  }
  return nurbs_curve(3, control, weights, {0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1});
}

NurbsCurve conic_arc(const glm::dvec2& from, const glm::dvec2& control, const glm::dvec2& to,
                     double middle_weight) {
  const std::array<glm::dvec2, 3> points = {from, control, to};
  return nurbs_curve(3, points, std::array{1.0, middle_weight, 1.0}, {0, 0, 0, 1, 1, 1});
}

}  // namespace kinescope
