// Anti-aliasing by area: the exact share of each pixel that is inside.
// Source: E. Catmull, "A hidden-surface algorithm with anti-aliasing", 1978; by ExactArea's sums.
#pragma once

#include <span>

#include "raster/fill/polygon.h"
#include "raster/path/exact_area.h"
#include "raster/pixel_rect.h"

namespace kinescope {

/// Calls sink(x, y, weight) for each pixel that is touched, row by row.
template <typename Sink>
void area_coverage(const Polygon& polygon, FillRule rule, const PixelRect& window, Sink&& sink) {
  if (window.empty()) return;
  ExactArea area(window.x1 - window.x0, window.y1 - window.y0);
  const glm::dvec2 corner(window.x0, window.y0);
  for (const Contour& contour : polygon) {
    contour_edges(contour,
                  [&](glm::dvec2 a, glm::dvec2 b) { area.add_edge(a - corner, b - corner); });
  }
  area.rows(rule, [&](int y, std::span<const float> row) {
    for (std::size_t x = 0; x < row.size(); ++x) {
      if (row[x] > 0) sink(window.x0 + static_cast<int>(x), window.y0 + y, row[x]);
    }
  });
}

}  // namespace kinescope
