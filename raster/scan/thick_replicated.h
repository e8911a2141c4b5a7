// A thick line by replicated pixels: each pixel of Bresenham's line becomes a short column (a row,
// if the line is steep). Cheap; sloping lines come out thinner unless the columns are lengthened.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, 3.9.1.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "raster/scan/bresenham_steps.h"

namespace kinescope {

/// Pixels that a column needs for a line of this width across itself: width * length / major.
inline int replicas(glm::ivec2 from, glm::ivec2 to, double width_px) {
  const double dx = std::abs(double{1} * to.x - from.x), dy = std::abs(double{1} * to.y - from.y);
  const double major = std::max(dx, dy);
  const double factor = major > 0 ? std::hypot(dx, dy) / major : 1;
  const double count = std::floor(width_px * factor + 0.5);
  return count >= 1 ? static_cast<int>(std::min(count, double{kLargestCoordinate})) : 1;  // NaN: 1
}

/// Calls sink(x, y) for each pixel, none twice. Of an even count the odd one is on the greater
/// side.
/// @param count pixels a column: the width, or replicas()
template <typename Sink>
void replicated_line(glm::ivec2 from, glm::ivec2 to, int count, Sink&& sink) {
  for (BresenhamSteps line(from, to); line.next();) {
    const glm::ivec2 p = line.at();
    for (int i = -((count - 1) / 2); i <= count / 2; ++i) {
      if (line.steep()) {
        sink(p.x + i, p.y);
      } else {
        sink(p.x, p.y + i);
      }
    }
  }
}

}  // namespace kinescope
