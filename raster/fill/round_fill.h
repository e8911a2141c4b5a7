// Discs and filled ellipses: the runs between the outline's pixels, the outline included.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, 3.6.
#pragma once

#include "raster/scan/midpoint_circle.h"
#include "raster/scan/midpoint_ellipse.h"
#include "raster/scan/row_span.h"

namespace kinescope {

/// Calls sink(RowSpan) once for each row of the midpoint ellipse, from the middle outwards or from
/// the outer rows in: in pairs above and below. A negative radius has none.
/// @throws Error (bad input) beyond the limits
template <typename Sink>
void filled_ellipse(glm::ivec2 centre, glm::ivec2 radii, Sink&& sink) {
  check_round(centre, std::max(radii.x, radii.y));
  const auto row = [&](glm::ivec2 p) {
    const int begin = centre.x - p.x, end = centre.x + p.x + 1;
    sink(RowSpan{centre.y - p.y, begin, end});
    if (p.y != 0) sink(RowSpan{centre.y + p.y, begin, end});
  };
  // The last pixel of a row lies furthest out.
  MidpointEllipse outline(radii);
  if (!outline.next()) return;
  glm::ivec2 before = outline.at();
  while (outline.next()) {
    if (outline.at().y != before.y) row(before);
    before = outline.at();
  }
  row(before);
}

/// The same for the midpoint circle.
template <typename Sink>
void filled_circle(glm::ivec2 centre, int radius, Sink&& sink) {
  check_round(centre, radius);
  const auto rows = [&](int y, int half) {
    const int begin = centre.x - half, end = centre.x + half + 1;
    sink(RowSpan{centre.y - y, begin, end});
    if (y != 0) sink(RowSpan{centre.y + y, begin, end});
  };
  glm::ivec2 before{0, -1};
  MidpointCircle octant(radius);
  while (octant.next()) {
    const glm::ivec2 p = octant.at();
    if (before.y >= 0 && p.y != before.y) rows(before.y, before.x);
    rows(p.x, p.y);
    before = p;
  }
  // The last height is a row of its own unless it lies on the diagonal.
  if (before.y > before.x) rows(before.y, before.x);
}

}  // namespace kinescope
