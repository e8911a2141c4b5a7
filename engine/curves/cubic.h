// Cubic pieces given by four weights a basis: what Hermite, Catmull-Rom, Bezier and uniform
// B-spline curves have in common, and their blending functions. Source: Foley, van Dam, Feiner,
// Hughes, "Computer Graphics: Principles and Practice", 1990, 11.2.
#pragma once

#include <array>

namespace kinescope {

using CubicWeights = std::array<double, 4>;

/// Of two points and the slopes there: p0, p1, m0, m1.
inline CubicWeights hermite_weights(double t) {
  const double s = 1.0 - t;
  return {s * s * (1.0 + 2.0 * t), t * t * (3.0 - 2.0 * t), s * s * t, -s * t * t};
}

/// Of four points, of which the curve joins the middle two. Tension 0 is Catmull-Rom's, 1 makes the
/// piece straight: the cardinal splines.
inline CubicWeights catmull_rom_weights(double t, double tension = 0.0) {
  const auto [p, q, m, n] = hermite_weights(t);
  const double half = 0.5 * (1.0 - tension);
  return {-half * m, p - half * n, q + half * m, half * n};
}

inline CubicWeights cubic_bezier_weights(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

inline CubicWeights cubic_b_spline_weights(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, (3.0 * t * t * (t - 2.0) + 4.0) / 6.0,
          (3.0 * s * s * (s - 2.0) + 4.0) / 6.0, t * t * t / 6.0};
}

/// Calls sink(t, weights) at `count` + 1 places evenly over [0, 1]: for drawing blending functions.
template <typename Weights, typename Sink>
void blending_functions(Weights&& weights, int count, Sink&& sink) {
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    sink(t, weights(t));
  }
}

/// The weighted sum of four control points or slopes.
template <typename Vec>
Vec blend(const CubicWeights& weight, const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
  return weight[0] * a + weight[1] * b + weight[2] * c + weight[3] * d;
}

/// The same piece as a Bezier curve, whose slopes are three times its legs.
template <typename Vec>
std::array<Vec, 4> bezier_from_hermite(const Vec& p0, const Vec& p1, const Vec& m0, const Vec& m1) {
  return {p0, p0 + m0 / 3.0, p1 - m1 / 3.0, p1};
}

}  // namespace kinescope
