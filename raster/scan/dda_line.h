// A line by the digital differential analyzer: equal steps of real numbers, rounded at each pixel.
// Source: W. M. Newman and R. F. Sproull, "Principles of Interactive Computer Graphics", 1979.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/scan/limits.h"

namespace kinescope {

/// One pixel a step along the axis of the greater difference. Ends that are not finite or lie
/// beyond kLargestCoordinate give no pixel. Sums of rounded steps drift: with these doubles by far
/// less than a pixel up to a million steps.
class DdaLine {
 public:
  DdaLine(glm::dvec2 from, glm::dvec2 to) : position_(from) {
    if (!is_drawable(from) || !is_drawable(to)) return;
    const glm::dvec2 d = to - from;
    const double steps = std::ceil(std::max(std::abs(d.x), std::abs(d.y)));
    if (steps > 0) increment_ = d / steps;
    left_ = static_cast<std::int64_t>(steps) + 1;
  }

  /// Moves to the next pixel (at first: to the first); false behind the last.
  bool next() {
    if (left_ == 0) return false;
    if (begun_) position_ += increment_;
    begun_ = true;
    --left_;
    return true;
  }
  glm::ivec2 at() const {
    return {static_cast<int>(std::floor(position_.x + 0.5)),
            static_cast<int>(std::floor(position_.y + 0.5))};
  }
  glm::dvec2 position() const { return position_; }    ///< before rounding
  glm::dvec2 increment() const { return increment_; }  ///< a step; one of its parts is 1 or -1

 private:
  glm::dvec2 position_, increment_{0};
  std::int64_t left_ = 0;
  bool begun_ = false;
};

/// Calls sink(x, y) for each pixel from one end to the other.
template <typename Sink>
void dda_line(glm::dvec2 from, glm::dvec2 to, Sink&& sink) {
  for (DdaLine line(from, to); line.next();) sink(line.at().x, line.at().y);
}

}  // namespace kinescope
