// A thick line as what it is: a rectangle, filled. Right in width and length at every slope.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, 3.9.3.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "raster/fill/scanline_fill.h"

namespace kinescope {

/// The rectangle of a line between points in pixels (a pixel's centre lies at + 1/2), with butt
/// ends; a line without length, or whose figures are not finite, has no corners.
inline Polygon thick_rectangle(glm::dvec2 from, glm::dvec2 to, double width_px) {
  const glm::dvec2 d = to - from;
  const double length = std::hypot(d.x, d.y);
  if (!(length > 0) || !std::isfinite(length) || !(width_px > 0)) return {};
  const glm::dvec2 side = glm::dvec2(-d.y, d.x) * (width_px / (2 * length));
  return {{from + side, to + side, to - side, from - side}};
}

/// Calls sink(RowSpan) for each row of the line. @throws Error (bad input) beyond ScanlineFill's
/// limits
template <typename Sink>
void thick_line_area(glm::dvec2 from, glm::dvec2 to, double width_px, const PixelRect& window,
                     Sink&& sink) {
  scanline_fill(thick_rectangle(from, to, width_px), FillRule::kNonZero, window, sink);
}

}  // namespace kinescope
