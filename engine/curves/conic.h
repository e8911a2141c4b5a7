// Conic sections a x^2 + b x y + c y^2 + d x + e y + f = 0, told apart.
#pragma once

#include <glm/vec2.hpp>

namespace kinescope {

struct Conic {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;

  double value(const glm::dvec2& p) const {
    return a * p.x * p.x + b * p.x * p.y + c * p.y * p.y + d * p.x + e * p.y + f;
  }
  /// Across the curve: (2 a x + b y + d, b x + 2 c y + e).
  glm::dvec2 gradient(const glm::dvec2& p) const {
    return {2 * a * p.x + b * p.y + d, b * p.x + 2 * c * p.y + e};
  }
  double discriminant() const { return b * b - 4 * a * c; }
};

enum class ConicKind { kNone, kLine, kCircle, kEllipse, kParabola, kHyperbola };

/// By the sign of the discriminant alone, as the textbook does: an ellipse may be a point or empty,
/// a hyperbola two lines that cross. kNone has no terms in x and y.
inline ConicKind conic_kind(const Conic& q) {
  if (q.a == 0 && q.b == 0 && q.c == 0) {
    return q.d == 0 && q.e == 0 ? ConicKind::kNone : ConicKind::kLine;
  }
  if (q.a == q.c && q.b == 0) return ConicKind::kCircle;
  const double discriminant = q.discriminant();
  if (discriminant < 0) return ConicKind::kEllipse;
  return discriminant > 0 ? ConicKind::kHyperbola : ConicKind::kParabola;
}

}  // namespace kinescope
