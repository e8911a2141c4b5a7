// A circle by its explicit equation, y = sqrt(r^2 - x^2): a root a pixel.
// Source: D. Hearn and M. P. Baker, "Computer Graphics", 1986.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "raster/scan/circle_symmetry.h"
#include "raster/scan/limits.h"

namespace kinescope {

/// The octant from (0, r) to the diagonal, column by column. A negative radius has no pixel.
class ExplicitCircle {
 public:
  explicit ExplicitCircle(int radius) : radius_(radius) {}

  bool next() {
    if (radius_ < 0) return false;
    ++at_.x;
    const double r = radius_, x = at_.x;
    if (x > r) return false;
    height_ = std::sqrt((r - x) * (r + x));
    at_.y = static_cast<int>(std::floor(height_ + 0.5));
    return at_.x <= at_.y;
  }
  glm::ivec2 at() const { return at_; }      ///< from the centre
  double height() const { return height_; }  ///< y before rounding

 private:
  int radius_;
  glm::ivec2 at_{-1, 0};
  double height_ = 0;
};

/// @throws Error (bad input) beyond the limits
template <typename Sink>
void explicit_circle(glm::ivec2 centre, int radius, Sink&& sink) {
  check_round(centre, radius);
  all_octants(ExplicitCircle(radius), centre, sink);
}

}  // namespace kinescope
