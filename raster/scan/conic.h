// The general conic a x^2 + b xy + c y^2 + d x + e y + f = 0.
#pragma once

#include <glm/vec2.hpp>

namespace kinescope {

/// By the sign of b^2 - 4ac; a degenerate conic (a pair of lines, a point, nothing) has the kind of
/// those that it is the limit of. kNone has no terms in x and y.
enum class ConicKind { kNone, kEllipse, kCircle, kParabola, kHyperbola, kLine };

struct Conic {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;

  /// The left side: its sign tells the sides of the curve.
  double operator()(double x, double y) const {
    return (a * x + b * y + d) * x + (c * y + e) * y + f;
  }
  glm::dvec2 gradient(double x, double y) const {
    return {2 * a * x + b * y + d, b * x + 2 * c * y + e};
  }
  double discriminant() const { return b * b - 4 * a * c; }
  ConicKind kind() const;

  /// An ellipse by its centre, radii and the angle from the x axis to the first, radians.
  static Conic ellipse(glm::dvec2 centre, glm::dvec2 radii, double angle);
  /// (y - vertex.y)^2 = 4 focus_distance (x - vertex.x), turned about its vertex.
  static Conic parabola(glm::dvec2 vertex, double focus_distance, double angle);
  /// x^2/a^2 - y^2/b^2 = 1 about its centre, turned.
  static Conic hyperbola(glm::dvec2 centre, glm::dvec2 semi_axes, double angle);

 private:
  /// p u^2 + q v^2 + r u + s = 0 in axes u, v turned by the angle about the origin given.
  static Conic turned(double p, double q, double r, double s, glm::dvec2 origin, double angle);
};

}  // namespace kinescope
