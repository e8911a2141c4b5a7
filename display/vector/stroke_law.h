// How a stroke is cut into parts that have a closed form. Shared by the kernel and its scalar twin.
//
// Broad spots: a pixel's square is close to a Gaussian of deviation 1/sqrt(12), so that spot and
// pixel together are one Gaussian; its fourth cumulant is put right across the stroke. Moved along
// a line it is a Gaussian across times a difference of normal distributions along.
// Narrow spots and short strokes: the integral over time by Gauss and Legendre, of spots whose
// integral over a pixel is a product of differences of normal distributions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "display/vector/beam_stroke.h"

namespace kinescope::stroke_law {

/// From here on the sum over pixels of a sampled spot is even to one part in a million.
inline constexpr float kBroadSigma = 0.8f;
/// In deviations: from here on a stroke's ends are far enough apart for the closed form, which puts
/// a pixel's shape right across them only.
inline constexpr float kLineLength = 4;
/// In deviations: as far as a few spots make a stroke.
inline constexpr float kPartLength = 5;

/// Below kSpotReach, of what lies within it.
inline const double kWithinReach = std::erf(kSpotReach / std::numbers::sqrt2);
/// Mean square of a place in a pixel about its middle.
inline constexpr float kPixelVariance = 1.0f / 12;

inline float length_of(const BeamStroke& s) { return std::hypot(s.x1 - s.x0, s.y1 - s.y0); }
inline float drawn_sigma(const BeamStroke& s) { return std::max(s.sigma, kLeastSigma); }

inline bool has_closed_form(float sigma, float length) {
  return sigma >= kBroadSigma && length > kLineLength * sigma;
}
/// Parts of one that has none.
inline int parts_of(float sigma, float length) {
  return std::max(1, static_cast<int>(std::ceil(length / (kPartLength * sigma))));
}

/// Nodes on [-1, 1] and weights that add up to 1 (Abramowitz and Stegun, table 25.4).
struct Quadrature {
  int nodes;
  std::array<float, BeamSpots::kMost> at, weight;
};
inline constexpr std::array<Quadrature, BeamSpots::kMost> kQuadratures{{
    {1, {0}, {1}},
    {2, {-0.577350269f, 0.577350269f}, {0.5f, 0.5f}},
    {3, {-0.774596669f, 0, 0.774596669f}, {0.277777778f, 0.444444444f, 0.277777778f}},
    {4,
     {-0.861136312f, -0.339981044f, 0.339981044f, 0.861136312f},
     {0.173927423f, 0.326072577f, 0.326072577f, 0.173927423f}},
    {5,
     {-0.906179846f, -0.538469310f, 0, 0.538469310f, 0.906179846f},
     {0.118463443f, 0.239314335f, 0.284444444f, 0.239314335f, 0.118463443f}},
    {6,
     {-0.932469514f, -0.661209386f, -0.238619186f, 0.238619186f, 0.661209386f, 0.932469514f},
     {0.085662246f, 0.180380787f, 0.233956967f, 0.233956967f, 0.180380787f, 0.085662246f}},
}};

/// The least one that errs by less than three parts in 10^4 of a long line's peak, or a shorter
/// one's own, over a part so many deviations long.
inline const Quadrature& quadrature_for(float deviations) {
  constexpr std::array<float, 5> kLongest{0.13f, 1.0f, 2.0f, 3.0f, 4.0f};
  std::size_t i = 0;
  while (i < kLongest.size() && deviations > kLongest[i]) ++i;
  return kQuadratures[i];
}

/// A stroke in closed form, in deviations of spot and pixel together.
struct Line {
  float along_x, along_y;    ///< deviations along it, a pixel right and a pixel down
  float across_x, across_y;  ///< across it
  float along_0, across_0;   ///< at the place that counts as (0, 0)
  float length;
  float peak;    ///< share a pixel in the middle of a long one
  float fourth;  ///< times the fourth Hermite polynomial: what a pixel lacks of a Gaussian
  float rows_along, rows_across;  ///< pixels down a deviation along and across; 0: too many
  float ratio_step;  ///< by which the ratio of the heights of neighbouring rows changes
  float reach;       ///< pixels

  /// @param x, y the pixel whose middle counts as (0, 0)
  Line(const BeamStroke& s, float length_px, float x, float y) {
    const float sigma = std::sqrt(s.sigma * s.sigma + kPixelVariance);
    const float ux = (s.x1 - s.x0) / length_px, uy = (s.y1 - s.y0) / length_px;
    along_x = ux / sigma, along_y = uy / sigma;
    across_x = -along_y, across_y = along_x;
    const float left = x + 0.5f - s.x0, above = y + 0.5f - s.y0;
    along_0 = left * along_x + above * along_y;
    across_0 = left * across_x + above * across_y;
    length = length_px / sigma;
    const float inverse_root_2pi = 0.39894228f / static_cast<float>(kWithinReach);
    peak = inverse_root_2pi / (length_px * sigma);
    const float variance = sigma * sigma;
    const auto inverse = [](float v) { return std::abs(v) < 1e-6f ? 0 : 1 / v; };
    rows_along = inverse(along_y), rows_across = inverse(across_y);
    ratio_step = std::exp(-across_y * across_y);
    reach = kSpotReach * sigma;
    fourth = (ux * ux * ux * ux + uy * uy * uy * uy) / (2880 * variance * variance);
  }
};

}  // namespace kinescope::stroke_law
