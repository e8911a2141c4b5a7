// Anti-aliasing by supersampling: the share of n x n evenly spaced points of a pixel that are
// inside.
// Source: F. C. Crow, "A comparison of antialiasing techniques", 1981.
#pragma once

#include <algorithm>
#include <vector>

#include "raster/fill/scanline_fill.h"

namespace kinescope {

/// Calls sink(x, y, weight) for each pixel with a point inside, row by row.
/// @param n points a side, 1 to 64 (clamped). @throws Error (bad input) where ScanlineFill does, of
/// coordinates n times as large
template <typename Sink>
void supersample(const Polygon& polygon, FillRule rule, const PixelRect& window, int n,
                 Sink&& sink) {
  if (window.empty()) return;
  n = std::clamp(n, 1, 64);
  Polygon large = polygon;
  for (Contour& contour : large) {
    for (glm::dvec2& corner : contour) corner *= n;
  }
  ScanlineFill fill({window.x0 * n, window.y0 * n, window.x1 * n, window.y1 * n}, rule);
  fill.add(large);
  std::vector<int> counts(static_cast<std::size_t>(window.x1 - window.x0));
  int y = window.y0;
  const auto flush = [&] {
    for (int x = window.x0; x < window.x1; ++x) {
      int& count = counts[static_cast<std::size_t>(x - window.x0)];
      if (count) sink(x, y, static_cast<float>(count) / static_cast<float>(n * n));
      count = 0;
    }
  };
  while (fill.next()) {
    // Rows of points from the window's first on, so that division rounds as it should.
    const int row = window.y0 + (fill.y() - window.y0 * n) / n;
    if (row != y) flush();
    y = row;
    for (const RowSpan& span : fill.spans()) {
      for (int s = span.x_begin - window.x0 * n; s < span.x_end - window.x0 * n; ++s) {
        ++counts[static_cast<std::size_t>(s / n)];
      }
    }
  }
  flush();
}

}  // namespace kinescope
