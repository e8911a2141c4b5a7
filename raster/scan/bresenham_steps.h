// Bresenham's line as a stepper like the other algorithms here, and as runs.
// Source: J. E. Bresenham, "Run length slice algorithm for incremental lines", 1985.
#pragma once

#include <glm/vec2.hpp>

#include "raster/line.h"
#include "raster/scan/limits.h"

namespace kinescope {

/// BresenhamLine, pixel by pixel with both ends.
class BresenhamSteps {
 public:
  /// @throws Error (bad input) beyond kLargestCoordinate
  BresenhamSteps(glm::ivec2 from, glm::ivec2 to)
      : line_((check_coordinates(from), check_coordinates(to), from.x), from.y, to.x, to.y),
        left_(line_.steps() + 1) {}

  bool next() {
    if (left_ == 0) return false;
    if (left_ <= line_.steps()) line_.step();
    --left_;
    return true;
  }
  glm::ivec2 at() const { return {line_.x(), line_.y()}; }
  /// 2 dy - dx at first (axes in the octant of the line): not negative where the next step also
  /// goes aside.
  std::int64_t decision() const { return line_.error(); }
  bool steep() const { return line_.steep(); }  ///< y is the axis of the steps

 private:
  BresenhamLine line_;
  std::int64_t left_;
};

}  // namespace kinescope
