// Boundary fill: everything up to pixels of the boundary's value.
// Source: D. Hearn and M. P. Baker, "Computer Graphics", 1986; by runs, where the book recurses.
#pragma once

#include "raster/fill/span_fill.h"
#include "raster/image/image.h"

namespace kinescope {

/// The fill as a stepper. The picture may be painted on while it runs; unlike the recursive fill it
/// does not stop at pixels that had the new colour before.
template <typename Value>
auto boundary_filler(const Image<Value>& image, int x, int y, const Value& boundary,
                     Connectivity connectivity) {
  const auto inside = [&image, boundary](int u, int v) { return !(image.at(u, v) == boundary); };
  return SpanFill({0, 0, image.width(), image.height()}, inside, x, y, connectivity);
}

/// Calls sink(RowSpan) for each run; a seed outside the picture, or on the boundary, has none.
template <typename Value, typename Sink>
void boundary_fill(const Image<Value>& image, int x, int y, const Value& boundary,
                   Connectivity connectivity, Sink&& sink) {
  for (auto fill = boundary_filler(image, x, y, boundary, connectivity); fill.next();) {
    sink(fill.span());
  }
}

}  // namespace kinescope
