// Which samples a triangle covers, written another way than the rasterizer's edge functions: which
// side of each edge's line does a sample share with the opposite corner, in 128-bit integers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "raster/sample_pattern.h"

namespace kinescope::exactness {

__extension__ using Wide = __int128;

/// In 256ths of a pixel.
struct Point {
  std::int64_t x, y;
};

/// llrint rounds to nearest even, as the hardware's conversion does.
inline Point snapped(float x_px, float y_px) {
  return {std::llrint(double{x_px} * 256), std::llrint(double{y_px} * 256)};
}

inline Point sample_point(int x, int y, SampleOffset o) {
  return {std::int64_t{x} * 256 + o.x.raw(), std::int64_t{y} * 256 + o.y.raw()};
}

class CoverageOracle {
 public:
  explicit CoverageOracle(const std::array<Point, 3>& corners) : corner_(corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = corner_[i], b = corner_[(i + 1) % 3], c = corner_[(i + 2) % 3];
      inside_[i] = side(a, b, c);
      owns_[i] = owns_line(a, b, c);
    }
  }

  bool covers(Point p) const {
    if (inside_[0] == 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const int s = side(corner_[i], corner_[(i + 1) % 3], p);
      if (s == 0 ? !owns_[i] : s != inside_[i]) return false;
    }
    return true;
  }

 private:
  static int side(Point a, Point b, Point p) {
    const Wide v = Wide{b.x - a.x} * (p.y - a.y) - Wide{p.x - a.x} * (b.y - a.y);
    return (v > 0) - (v < 0);
  }

  /// On the line of the edge a-b: the triangle owns it if its inside lies below a level edge (a top
  /// edge), or to the right of any other (a left edge).
  static bool owns_line(Point a, Point b, Point opposite) {
    if (a.y == b.y) return opposite.y > a.y;
    if (a.y > b.y) std::swap(a, b);
    // x of the line at the height of the opposite corner, times the positive height b.y - a.y.
    const Wide height = b.y - a.y;
    const Wide line_x = a.x * height + Wide{b.x - a.x} * (opposite.y - a.y);
    return opposite.x * height > line_x;
  }

  std::array<Point, 3> corner_;
  std::array<int, 3> inside_;  ///< the side of each edge on which the triangle lies
  std::array<bool, 3> owns_;
};

}  // namespace kinescope::exactness
