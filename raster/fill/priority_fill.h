// Priority fill: areas painted from the farthest to the nearest, so that the nearest stays.
// Source: M. E. Newell, R. G. Newell and T. L. Sancha, "A solution to the hidden surface problem",
// 1972.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "raster/fill/scanline_fill.h"

namespace kinescope {

struct PriorityArea {
  Polygon polygon;
  double distance = 0;  ///< from the viewer; not a number counts as farthest
  FillRule rule = FillRule::kNonZero;
};

/// The order of painting: farthest first, of equals the one given first.
inline std::vector<std::size_t> painting_order(std::span<const PriorityArea> areas) {
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto distance = [&](std::size_t i) {
    return std::isnan(areas[i].distance) ? HUGE_VAL : areas[i].distance;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) > distance(b); });
  return order;
}

/// Calls sink(index of the area, RowSpan) in the order of painting.
template <typename Sink>
void priority_fill(std::span<const PriorityArea> areas, const PixelRect& window, Sink&& sink) {
  for (const std::size_t i : painting_order(areas)) {
    scanline_fill(areas[i].polygon, areas[i].rule, window,
                  [&](const RowSpan& span) { sink(i, span); });
  }
}

}  // namespace kinescope
