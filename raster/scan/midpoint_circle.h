// A circle in integers by the side of the curve on which the midpoint of two pixels lies.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, after
// M. L. V. Pitteway, 1967.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/pixel_rect.h"
#include "raster/scan/circle_symmetry.h"
#include "raster/scan/limits.h"

namespace kinescope {

/// The octant from (0, r) to the diagonal. A negative radius has no pixel.
class MidpointCircle {
 public:
  explicit MidpointCircle(int radius) : radius_(radius), x_(-1), y_(radius), decision_(1 - y_) {}

  bool next() {
    if (x_ >= 0) {
      if (decision_ < 0) {
        decision_ += 2 * x_ + 3;
      } else {
        decision_ += 2 * (x_ - y_) + 5;
        --y_;
      }
    }
    ++x_;
    return x_ <= y_;
  }
  glm::ivec2 at() const { return {x_, y_}; }  ///< from the centre
  /// x^2 + y^2 - r^2 at (x + 1, y - 1/2), less the 1/4 that no whole number can tell: negative
  /// where that midpoint is inside.
  std::int64_t decision() const { return decision_; }

  /// As if next() had come to column x, at once.
  void skip_to(int x);
  /// The height of column x, 0 <= x <= r.
  std::int64_t height(std::int64_t x) const;

 private:
  std::int64_t radius_, x_, y_, decision_;
};

/// @throws Error (bad input) beyond the limits
template <typename Sink>
void midpoint_circle(glm::ivec2 centre, int radius, Sink&& sink) {
  check_round(centre, radius);
  all_octants(MidpointCircle(radius), centre, sink);
}

/// Columns [begin, end) of an octant, counted from the centre.
struct OctantRange {
  int begin = 0, end = 0;
};
/// Those whose pixels, mirrored to octant 0 to 7, lie in the window. Octants: bit 0 mirrors x,
/// bit 1 y, bit 2 exchanges them first.
OctantRange octant_within(glm::ivec2 centre, int radius, int octant, const PixelRect& window);

/// The same pixels as midpoint_circle, without those outside the window: the cost is of what is
/// seen, however large the circle, up to kLargestCoordinate.
template <typename Sink>
void midpoint_circle_clipped(glm::ivec2 centre, int radius, const PixelRect& window, Sink&& sink) {
  check_round(centre, radius, kLargestCoordinate);
  for (int octant = 0; octant < 8; ++octant) {
    const OctantRange range = octant_within(centre, radius, octant, window);
    if (range.begin >= range.end) continue;
    MidpointCircle circle(radius);
    circle.skip_to(range.begin);
    do {
      const glm::ivec2 p = circle.at();
      const glm::ivec2 q = octant & 4 ? glm::ivec2(p.y, p.x) : p;
      // The pixels on the axes and the diagonal belong to several octants; the first one gives
      // them.
      const bool shared =
          (q.x == 0 && octant & 1) || (q.y == 0 && octant & 2) || (p.x == p.y && octant & 4);
      if (shared) continue;
      sink(centre.x + (octant & 1 ? -q.x : q.x), centre.y + (octant & 2 ? -q.y : q.y));
    } while (circle.next() && circle.at().x < range.end);
  }
}

}  // namespace kinescope
