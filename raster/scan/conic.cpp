#include "raster/scan/conic.h"

#include <cmath>

namespace kinescope {

ConicKind Conic::kind() const {
  if (a == 0 && b == 0 && c == 0) return d == 0 && e == 0 ? ConicKind::kNone : ConicKind::kLine;
  const double sign = discriminant();
  // A parabola that was turned has rounded coefficients.
  if (std::abs(sign) <= 1e-12 * (b * b + std::abs(4 * a * c))) return ConicKind::kParabola;
  if (sign > 0) return ConicKind::kHyperbola;
  return a == c && b == 0 ? ConicKind::kCircle : ConicKind::kEllipse;
}

Conic Conic::turned(double p, double q, double r, double s, glm::dvec2 origin, double angle) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  Conic k;
  k.a = p * cosine * cosine + q * sine * sine;
  k.b = 2 * (p - q) * cosine * sine;
  k.c = p * sine * sine + q * cosine * cosine;
  // About the origin given: F(x - x0, y - y0), multiplied out.
  const double d = r * cosine, e = r * sine;
  k.d = d - 2 * k.a * origin.x - k.b * origin.y;
  k.e = e - 2 * k.c * origin.y - k.b * origin.x;
  k.f = s - d * origin.x - e * origin.y + (k.a * origin.x + k.b * origin.y) * origin.x +
        k.c * origin.y * origin.y;
  return k;
}

Conic Conic::ellipse(glm::dvec2 centre, glm::dvec2 radii, double angle) {
  const double aa = radii.x * radii.x, bb = radii.y * radii.y;
  return turned(bb, aa, 0, -aa * bb, centre, angle);
}

Conic Conic::parabola(glm::dvec2 vertex, double focus_distance, double angle) {
  return turned(0, 1, -4 * focus_distance, 0, vertex, angle);
}

Conic Conic::hyperbola(glm::dvec2 centre, glm::dvec2 semi_axes, double angle) {
  const double aa = semi_axes.x * semi_axes.x, bb = semi_axes.y * semi_axes.y;
  return turned(bb, -aa, 0, -aa * bb, centre, angle);
}

}  // namespace kinescope
