// Circles and ellipses by a digital differential analyzer: x' = -(a/b) y, y' = (b/a) x, in steps of
// a power of two. Each step uses the x that was just found: the points then stay on a closed curve,
// where with the x before it they would spiral outwards.
// Source: W. M. Newman and R. F. Sproull, "Principles of Interactive Computer Graphics", 1979.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <numbers>

#include "raster/scan/limits.h"

namespace kinescope {

/// Once around from (a, 0); steps that stay in a pixel are passed over, and where the curve closes
/// its first pixel is not given twice. x is a cos t, y is b sin(t + step/2): the ellipse leans by a
/// quarter of a pixel at most. A negative radius has no pixel.
class DdaEllipse {
 public:
  explicit DdaEllipse(glm::ivec2 radii) : radii_(radii), position_(radii) {
    if (radii.x < 0 || radii.y < 0) return;
    while (step_ * std::max(radii.x, radii.y) >= 1) step_ /= 2;
    position_.y *= step_ / 2;
    left_ = static_cast<std::int64_t>(std::ceil(std::numbers::pi / std::asin(step_ / 2)));
  }

  bool next() {
    const glm::ivec2 before = at();
    do {
      if (left_ == 0) return false;
      --left_;
      if (begun_) advance();
    } while (begun_ &&
             (at() == before || (at() == first_ && static_cast<double>(left_) * step_ < 1)));
    if (!begun_) first_ = at();
    begun_ = true;
    return true;
  }
  glm::ivec2 at() const {  ///< from the centre
    return {static_cast<int>(std::floor(position_.x + 0.5)),
            static_cast<int>(std::floor(position_.y + 0.5))};
  }
  glm::dvec2 position() const { return position_; }  ///< before rounding
  double step() const { return step_; }              ///< of the angle, radians

 private:
  void advance() {
    const double a = radii_.x, b = radii_.y;
    // A flat ellipse is a line there and back, which the ratio of its radii cannot say.
    if (a == 0 || b == 0) {
      angle_ += step_;
      position_ = {a * std::cos(angle_), b * std::sin(angle_)};
      return;
    }
    position_.x -= step_ * (a / b) * position_.y;
    position_.y += step_ * (b / a) * position_.x;
  }

  glm::ivec2 radii_;
  glm::dvec2 position_;
  glm::ivec2 first_{0};
  double step_ = 1, angle_ = 0;
  std::int64_t left_ = 0;
  bool begun_ = false;
};

/// Calls sink(x, y) for each pixel once around; flat ones are passed there and back.
/// @throws Error (bad input) beyond the limits
template <typename Sink>
void dda_ellipse(glm::ivec2 centre, glm::ivec2 radii, Sink&& sink) {
  check_round(centre, std::max(radii.x, radii.y));
  for (DdaEllipse e(radii); e.next();) sink(centre.x + e.at().x, centre.y + e.at().y);
}

template <typename Sink>
void dda_circle(glm::ivec2 centre, int radius, Sink&& sink) {
  dda_ellipse(centre, {radius, radius}, sink);
}

}  // namespace kinescope
