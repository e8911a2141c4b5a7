// Curves through given points: piecewise Bezier cubics, from Hermite's, Catmull and Rom's and the
// natural conditions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/curves/cubic.h"

namespace kinescope {

/// One cubic piece, as its Bezier points.
template <typename Vec>
using CubicPiece = std::array<Vec, 4>;

/// Through points with a given slope at each. Needs two points, and as many slopes.
template <typename Vec>
std::vector<CubicPiece<Vec>> hermite_pieces(std::span<const Vec> points,
                                            std::span<const Vec> slopes) {
  std::vector<CubicPiece<Vec>> pieces;
  for (std::size_t i = 0; i + 1 < points.size() && i + 1 < slopes.size(); ++i) {
    pieces.push_back(bezier_from_hermite(points[i], points[i + 1], slopes[i], slopes[i + 1]));
  }
  return pieces;
}

/// The slope at each point along its neighbours' chord: local control, C1. The ends take their only
/// chord. Tension as in catmull_rom_weights.
/// Source: Catmull and Rom, "A Class of Local Interpolating Splines", 1974.
template <typename Vec>
std::vector<CubicPiece<Vec>> catmull_rom_pieces(std::span<const Vec> points, double tension = 0.0) {
  const std::size_t n = points.size();
  if (n < 2) return {};
  std::vector<Vec> slopes(n);
  slopes[0] = (1.0 - tension) * (points[1] - points[0]);
  slopes[n - 1] = (1.0 - tension) * (points[n - 1] - points[n - 2]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    slopes[i] = 0.5 * (1.0 - tension) * (points[i + 1] - points[i - 1]);
  }
  return hermite_pieces<Vec>(points, slopes);
}

/// Slopes that make the second derivatives meet everywhere and vanish at the ends: C2, but every
/// point moves the whole curve. A tridiagonal system, solved by Thomas's elimination.
/// Source: de Boor, "A Practical Guide to Splines", 1978, ch. 4.
template <typename Vec>
std::vector<Vec> natural_cubic_slopes(std::span<const Vec> points) {
  const std::size_t n = points.size();
  if (n < 2) return std::vector<Vec>(n, Vec(0.0));
  // 2 m0 + m1 = 3 (p1 - p0); m[i-1] + 4 m[i] + m[i+1] = 3 (p[i+1] - p[i-1]); and so at the end.
  std::vector<Vec> slope(n);
  std::vector<double> above(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = i == 0 || i + 1 == n;
    const Vec right = 3.0 * (points[i + 1 < n ? i + 1 : i] - points[i > 0 ? i - 1 : i]);
    const double pivot = (end ? 2.0 : 4.0) - (i > 0 ? above[i - 1] : 0.0);
    above[i] = 1.0 / pivot;
    slope[i] = (right - (i > 0 ? slope[i - 1] : Vec(0.0))) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) slope[i] -= above[i] * slope[i + 1];
  return slope;
}

template <typename Vec>
std::vector<CubicPiece<Vec>> natural_cubic_pieces(std::span<const Vec> points) {
  return hermite_pieces<Vec>(points, natural_cubic_slopes(points));
}

}  // namespace kinescope
