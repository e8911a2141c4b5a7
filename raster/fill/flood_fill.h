// Flood fill: the region of the seed's own value, whatever bounds it.
// Source: A. R. Smith, "Tint fill", 1979.
#pragma once

#include "raster/fill/span_fill.h"
#include "raster/image/image.h"

namespace kinescope {

/// The fill as a stepper. The picture may be painted on while it runs.
template <typename Value>
auto flood_filler(const Image<Value>& image, int x, int y, Connectivity connectivity) {
  const Value old = image.contains(x, y) ? image.at(x, y) : Value{};
  const auto inside = [&image, old](int u, int v) { return image.at(u, v) == old; };
  return SpanFill({0, 0, image.width(), image.height()}, inside, x, y, connectivity);
}

/// Calls sink(RowSpan) for each run; a seed outside the picture has none.
template <typename Value, typename Sink>
void flood_fill(const Image<Value>& image, int x, int y, Connectivity connectivity, Sink&& sink) {
  for (auto fill = flood_filler(image, x, y, connectivity); fill.next();) sink(fill.span());
}

}  // namespace kinescope
