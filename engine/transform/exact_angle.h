// Sine and cosine of an angle in degrees, exact where the textbook expects them to be.
#pragma once

#include <cmath>
#include <numbers>

namespace kinescope {

struct SineCosine {
  double sine, cosine;
};

/// Reduced to [-45, 45] degrees before the series: whole at quarter turns, a half at 30 and 60.
inline SineCosine sine_cosine_deg(double angle_deg) {
  int quarters = 0;
  const double rest_deg = std::remquo(angle_deg, 90.0, &quarters);
  const double rest = rest_deg * (std::numbers::pi / 180.0);
  const bool half = std::abs(rest_deg) == 30.0;
  const double s = half ? std::copysign(0.5, rest_deg) : std::sin(rest), c = std::cos(rest);
  switch (quarters & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace kinescope
