// An anti-aliased line of two pixels a step, whose weights are how near the line passes.
// Source: X. Wu, "An efficient antialiasing technique", 1991; the error is kept as an exact
// fraction where Wu keeps 16 bits of it.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <glm/vec2.hpp>
#include <utility>

#include "raster/scan/limits.h"

namespace kinescope {

/// One step along the major axis at a time, both ends included.
class WuLine {
 public:
  /// @throws Error (bad input) beyond kLargestCoordinate
  WuLine(glm::ivec2 from, glm::ivec2 to) : at_(from) {
    check_coordinates(from);
    check_coordinates(to);
    major_ = std::abs(to.x - from.x);
    minor_ = std::abs(to.y - from.y);
    along_ = {to.x < from.x ? -1 : 1, 0};
    aside_ = {0, to.y < from.y ? -1 : 1};
    if (minor_ > major_) {
      std::swap(major_, minor_);
      std::swap(along_, aside_);
    }
    left_ = major_ + 1;
  }

  bool next() {
    if (left_ == 0) return false;
    if (left_-- == major_ + 1) return true;
    at_ += along_;
    remainder_ += minor_;
    if (remainder_ >= major_) {
      remainder_ -= major_;
      at_ += aside_;
    }
    return true;
  }
  glm::ivec2 at() const { return at_; }               ///< the pixel on the near side of the line
  glm::ivec2 beside() const { return at_ + aside_; }  ///< and the one beyond it
  /// How far beyond at() the line passes, 0 to 1 pixel: the weight of beside(); at() has the rest.
  float fraction() const {
    return major_ ? static_cast<float>(remainder_) / static_cast<float>(major_) : 0;
  }

 private:
  glm::ivec2 at_, along_, aside_;
  std::int64_t major_, minor_, remainder_ = 0, left_;
};

/// Calls sink(x, y, weight) for each pixel whose weight is not 0; weights of a step add up to 1.
template <typename Sink>
void wu_line(glm::ivec2 from, glm::ivec2 to, Sink&& sink) {
  for (WuLine line(from, to); line.next();) {
    const float beyond = line.fraction();
    sink(line.at().x, line.at().y, 1 - beyond);
    if (beyond > 0) sink(line.beside().x, line.beside().y, beyond);
  }
}

}  // namespace kinescope
