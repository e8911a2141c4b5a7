// A triangle as the rasterizer sees it: snapped vertices, edge functions, a plane of depth.
// Source: J. Pineda, "A parallel algorithm for polygon rasterization", SIGGRAPH 1988.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "raster/base/fixed.h"
#include "raster/draw_call.h"

namespace kinescope {

/// Depth over the screen, anchored at the triangle's snapped first vertex and kept within the
/// depths of its vertices, so that bounds on those bound every sample.
struct DepthPlane {
  float x_px = 0, y_px = 0;         ///< the anchor
  float z = 0;                      ///< depth there
  float dz_dx = 0, dz_dy = 0;       ///< a pixel
  float nearest = 0, farthest = 0;  ///< of the vertices

  /// The one expression of depth: every path evaluates these roundings in this order.
  float at(float x, float y) const {
    const float row = z + dz_dy * (y - y_px);
    const float plane = row + dz_dx * (x - x_px);
    return std::min(std::max(plane, nearest), farthest);
  }
};

/// Vertices in 24.8 fixed point, turned so that the area is positive (clockwise on the screen,
/// since y runs down).
struct SnappedTriangle {
  std::array<std::int32_t, 3> x{}, y{};  ///< raw Fixed24_8
  std::int64_t double_area = 0;          ///< in raw units squared, positive
  DepthPlane depth;

  /// E(p) of the edge from vertex `i` to the next: positive inside. p in raw Fixed24_8.
  std::int64_t edge(int i, std::int64_t px, std::int64_t py) const {
    const int j = i == 2 ? 0 : i + 1;
    return (x[j] - x[i]) * (py - y[i]) - (y[j] - y[i]) * (px - x[i]);
  }
  /// Whether samples upon edge `i` belong to the triangle: it is a top edge or a left one.
  bool is_top_left(int i) const {
    const int j = i == 2 ? 0 : i + 1;
    return y[j] < y[i] || (y[j] == y[i] && x[j] > x[i]);
  }
};

/// Snaps triangle `triangle` of a call. False if it is culled: it faces away, has no area, or a
/// coordinate is not finite or lies beyond the guard band.
bool set_up_triangle(const DrawCall& call, std::size_t triangle, SnappedTriangle& out);

/// The same from vertices that were snapped, and turned to positive area, before.
/// @param z  depths in [0, 1]
void set_up_snapped(const std::array<std::int32_t, 3>& x, const std::array<std::int32_t, 3>& y,
                    const std::array<float, 3>& z, SnappedTriangle& out);

}  // namespace kinescope
