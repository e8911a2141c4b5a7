// A circle in integers by which of two pixels is nearer.
// Source: J. E. Bresenham, "A linear algorithm for incremental digital display of circular arcs",
// 1977, in the form d = 3 - 2r.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/scan/circle_symmetry.h"
#include "raster/scan/limits.h"

namespace kinescope {

/// The octant from (0, r) to the diagonal. A negative radius has no pixel.
class BresenhamCircle {
 public:
  explicit BresenhamCircle(int radius) : x_(-1), y_(radius), decision_(3 - 2 * y_) {}

  bool next() {
    if (x_ >= 0) {
      if (decision_ < 0) {
        decision_ += 4 * x_ + 6;
      } else {
        decision_ += 4 * (x_ - y_) + 10;
        --y_;
      }
    }
    ++x_;
    return x_ <= y_;
  }
  glm::ivec2 at() const { return {x_, y_}; }  ///< from the centre
  /// The sum of the two next pixels' errors x^2 + y^2 - r^2: not negative where the lower is
  /// nearer.
  std::int64_t decision() const { return decision_; }

 private:
  std::int64_t x_, y_, decision_;
};

/// @throws Error (bad input) beyond the limits
template <typename Sink>
void bresenham_circle(glm::ivec2 centre, int radius, Sink&& sink) {
  check_round(centre, radius);
  all_octants(BresenhamCircle(radius), centre, sink);
}

}  // namespace kinescope
