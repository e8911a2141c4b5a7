#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "display/vector/beam_stroke.h"
#include "display/vector/stroke_law.h"

namespace kinescope {
namespace {

/// A normal distribution's share below z deviations, less a half; cut off, and scaled to reach it.
double normal_below(double z) {
  const double reach = kSpotReach;
  z = std::clamp(z, -reach, reach);
  return 0.5 * std::erf(z / std::numbers::sqrt2) / stroke_law::kWithinReach;
}

/// Of a spot at rest, the share between two places on one axis.
double share_between(double from, double to, double middle, double sigma) {
  return normal_below((to - middle) / sigma) - normal_below((from - middle) / sigma);
}

double line_share(const BeamStroke& stroke, float length, int x, int y) {
  const stroke_law::Line line(stroke, length, static_cast<float>(x), static_cast<float>(y));
  const double v = line.across_0, u = line.along_0, q = v * v;
  if (std::abs(v) > kSpotReach) return 0;
  const double across = std::exp(-0.5 * q) * (1 - line.fourth * ((q - 6) * q + 3));
  return line.peak * across * (normal_below(u) - normal_below(u - line.length));
}

}  // namespace

double stroke_share(const BeamStroke& stroke, int x, int y) {
  const float length = stroke_law::length_of(stroke), sigma = stroke_law::drawn_sigma(stroke);
  if (stroke_law::has_closed_form(sigma, length)) return line_share(stroke, length, x, y);
  const int parts = stroke_law::parts_of(sigma, length);
  const auto& rule = stroke_law::quadrature_for(length / static_cast<float>(parts) / sigma);
  double sum = 0;
  for (int part = 0; part < parts; ++part) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(rule.nodes); ++k) {
      const double t = (part + 0.5 + 0.5 * static_cast<double>(rule.at[k])) / parts;
      const double cx =
          std::lerp(static_cast<double>(stroke.x0), static_cast<double>(stroke.x1), t);
      const double cy =
          std::lerp(static_cast<double>(stroke.y0), static_cast<double>(stroke.y1), t);
      sum += static_cast<double>(rule.weight[k]) * share_between(x, x + 1, cx, sigma) *
             share_between(y, y + 1, cy, sigma);
    }
  }
  return sum / parts;
}

double spots_share(const BeamSpots& spots, int x, int y) {
  double sum = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(spots.count); ++k) {
    const double sigma = std::max(spots.sigma[k], kLeastSigma), share = spots.share[k];
    sum += share * share_between(x, x + 1, spots.x[k], sigma) *
           share_between(y, y + 1, spots.y[k], sigma);
  }
  return sum;
}

}  // namespace kinescope
