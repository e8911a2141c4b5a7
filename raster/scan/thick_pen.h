// A thick line by a pen drawn along Bresenham's line: the pen's shape makes ends and corners round.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, 3.9.2.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "raster/scan/bresenham_steps.h"
#include "raster/scan/row_span.h"

namespace kinescope {

/// A pen that is one run of pixels in each of its rows, about its own pixel (0, 0).
struct Pen {
  std::vector<RowSpan> rows;

  static Pen round(int diameter);  ///< pixels whose centres lie within the diameter
  static Pen square(int side);
};

/// Calls sink(RowSpan) for each row that the pen touched, from the top; no pixel twice, since what
/// a convex pen covers of a row along a straight line is one run.
template <typename Sink>
void pen_line(glm::ivec2 from, glm::ivec2 to, const Pen& pen, Sink&& sink) {
  if (pen.rows.empty()) return;
  check_coordinates(from);
  check_coordinates(to);
  const int top = std::min(from.y, to.y) + pen.rows.front().y;
  const int rows = std::abs(to.y - from.y) + static_cast<int>(pen.rows.size());
  std::vector<RowSpan> touched(static_cast<std::size_t>(rows));
  for (BresenhamSteps line(from, to); line.next();) {
    for (const RowSpan& row : pen.rows) {
      const int y = line.at().y + row.y;
      RowSpan& span = touched[static_cast<std::size_t>(y - top)];
      const int begin = line.at().x + row.x_begin, end = line.at().x + row.x_end;
      span = span.length() == 0
                 ? RowSpan{y, begin, end}
                 : RowSpan{y, std::min(span.x_begin, begin), std::max(span.x_end, end)};
    }
  }
  for (const RowSpan& span : touched) sink(span);
}

}  // namespace kinescope
