// A circle by its parametric form, (r sin t, r cos t): two functions a pixel.
// Source: D. Hearn and M. P. Baker, "Computer Graphics", 1986.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <numbers>

#include "raster/scan/circle_symmetry.h"
#include "raster/scan/limits.h"

namespace kinescope {

/// The octant from (0, r) to the diagonal in steps of 1/r radian, a pixel's width of arc; steps
/// that stay in a pixel are passed over. A negative radius has no pixel.
class ParametricCircle {
 public:
  explicit ParametricCircle(int radius) : radius_(radius) {}

  bool next() {
    const glm::ivec2 before = at_;
    do {
      if (angle_ == kDiagonal || radius_ < 0) return false;
      ++step_;
      // The last step ends on the diagonal, also where a whole one would pass it by.
      angle_ = radius_ ? std::min(static_cast<double>(step_) / radius_, kDiagonal) : kDiagonal;
      at_ = {nearest(radius_ * std::sin(angle_)), nearest(radius_ * std::cos(angle_))};
      if (angle_ == kDiagonal) at_.y = at_.x = nearest(radius_ * std::numbers::sqrt2 / 2);
    } while (at_ == before);
    return true;
  }
  glm::ivec2 at() const { return at_; }    ///< from the centre
  double angle() const { return angle_; }  ///< from the y axis, radians

 private:
  static constexpr double kDiagonal = std::numbers::pi / 4;
  static int nearest(double v) { return static_cast<int>(std::floor(v + 0.5)); }

  int radius_;
  std::int64_t step_ = -1;
  double angle_ = 0;
  glm::ivec2 at_{-1, -1};
};

/// @throws Error (bad input) beyond the limits
template <typename Sink>
void parametric_circle(glm::ivec2 centre, int radius, Sink&& sink) {
  check_round(centre, radius);
  all_octants(ParametricCircle(radius), centre, sink);
}

}  // namespace kinescope
