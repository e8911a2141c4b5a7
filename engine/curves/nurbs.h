// Rational B-splines: curves of homogeneous points, which hold circles and every other conic.
// Source: Piegl and Tiller, "The NURBS Book", 2nd ed., 1997, ch. 4 and 7.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/curves/b_spline.h"

namespace kinescope {

/// Control points (w x, w y, w).
using NurbsCurve = BSpline<glm::dvec3>;

NurbsCurve nurbs_curve(int order, std::span<const glm::dvec2> control,
                       std::span<const double> weights, std::vector<double> knots);

/// The point at t. @throws Error (bad input) as check_knots
glm::dvec2 nurbs_point(const NurbsCurve& curve, double t);

/// Each control point's share of the point at t: w N over the sum of all. Empty where all weights
/// that count there are 0.
std::vector<double> rational_basis(const NurbsCurve& curve, double t);

/// A whole circle of nine control points, four quadratic quarters; t from 0 to 1, counter-clockwise
/// from +x.
NurbsCurve nurbs_circle(const glm::dvec2& centre, double radius);

/// The quadratic with end weights of 1: an arc of an ellipse for a middle weight below 1, of a
/// parabola at 1, of a hyperbola above.
NurbsCurve conic_arc(const glm::dvec2& from, const glm::dvec2& control, const glm::dvec2& to,
                     double middle_weight);

}  // namespace kinescope
