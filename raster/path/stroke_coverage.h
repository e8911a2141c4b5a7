// Anti-aliased lines: the exact area of a stroked segment in each pixel, row by row. The readable
// reference of line_kernel.cpp, and the way to draw a line anywhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "raster/path/stroke.h"

namespace kinescope {

/// Where coverage is wanted, pixels.
struct CoverageBox {
  int x_begin = 0, y_begin = 0, x_end = 0, y_end = 0;
};

/// What an edge adds to the pixels of one row.
struct RowEdge {
  double left, right;  ///< the pixels between which it lies, x
  double middle;       ///< of the edge, x
  float weight;        ///< the part of the row's height that it crosses, with the edge's sign
};

/// @return the edge's part in row y; weight is 0 if there is none
inline RowEdge edge_in_row(const OutlineEdges& edges, std::size_t i, int y) {
  const double from = std::max(edges.top[i], static_cast<double>(y));
  const double to = std::min(edges.bottom[i], static_cast<double>(y) + 1.0);
  if (!(to > from)) return {0, 0, 0, 0};
  const double x0 = edges.x[i] + (from - edges.top[i]) * edges.slope[i];
  const double x1 = edges.x[i] + (to - edges.top[i]) * edges.slope[i];
  return {std::min(x0, x1), std::max(x0, x1), 0.5 * (x0 + x1),
          static_cast<float>(to - from) * edges.sign[i]};
}

/// The whole pixels from x0 to x1 that lie in [begin, end).
struct PixelRange {
  PixelRange(double x0, double x1, int begin, int end)
      : first(static_cast<int>(std::clamp<double>(std::floor(x0), begin, end))),
        last(static_cast<int>(std::clamp<double>(std::ceil(x1), begin, end))) {}
  int first, last;  ///< last is excluded
};

/// Coverage of the pixels that row y of the outline touches, from the box's left to its right.
/// @return the first pixel's x
inline int stroke_row(const StrokeOutline& outline, int y, int x_begin, int x_end,
                      std::vector<float>& coverage) {
  coverage.clear();
  if (y >= outline.body_begin && y < outline.body_end) {
    const double middle =
        outline.left_x + outline.slope * (static_cast<double>(y) + 0.5 - outline.left_y);
    const double reach = 0.5 * std::abs(outline.slope);
    const PixelRange x(middle - reach, middle + outline.across + reach, x_begin, x_end);
    const double from_left = x.first + 0.5 - middle, from_right = from_left - outline.across;
    for (int i = 0; i < x.last - x.first; ++i) {
      const auto step = static_cast<float>(i);
      const float c = outline.ramp.at(static_cast<float>(from_left) + step) -
                      outline.ramp.at(static_cast<float>(from_right) + step);
      coverage.push_back(std::min(std::max(c, 0.0f), 1.0f));
    }
    return x.first;
  }
  double left = x_end, right = x_begin;
  for (const OutlineEdges& edges : outline.edges) {
    for (std::size_t i = 0; i < OutlineEdges::kCount; ++i) {
      const RowEdge edge = edge_in_row(edges, i, y);
      if (edge.weight == 0) continue;
      left = std::min(left, edge.left);
      right = std::max(right, edge.right);
    }
  }
  const PixelRange x(left, right, x_begin, x_end);
  coverage.resize(static_cast<std::size_t>(std::max(0, x.last - x.first)));
  for (const OutlineEdges& edges : outline.edges) {
    for (std::size_t i = 0; i < OutlineEdges::kCount; ++i) {
      const RowEdge edge = edge_in_row(edges, i, y);
      if (edge.weight == 0) continue;
      const Ramp ramp(static_cast<float>(edge.right - edge.left));
      const auto first = static_cast<float>(x.first + 0.5 - edge.middle);
      for (std::size_t k = 0; k < coverage.size(); ++k) {
        coverage[k] += edge.weight * (0.5f + ramp.at(first + static_cast<float>(k)));
      }
    }
  }
  for (float& c : coverage) c = std::min(std::max(c, 0.0f), 1.0f);
  return x.first;
}

/// Calls sink(x, y, coverage) for each row of the box that the stroked segment touches, from the
/// top: coverage in [0, 1] of the pixels from x on.
template <typename Sink>
void stroke_coverage(const Segment& segment, const Stroke& stroke, const CoverageBox& box,
                     Sink&& sink) {
  StrokeOutline outline;
  outline.set(segment, stroke);
  std::vector<float> coverage;
  const int end = std::min(outline.y_end, box.y_end);
  for (int y = std::max(outline.y_begin, box.y_begin); y < end; ++y) {
    const int x = stroke_row(outline, y, box.x_begin, box.x_end, coverage);
    if (!coverage.empty()) sink(x, y, std::span<const float>(coverage));
  }
}

}  // namespace kinescope
