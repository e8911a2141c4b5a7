// Polygons by scan lines, with an active edge table.
// Source: C. Wylie, G. Romney, D. Evans and A. Erdahl, "Half-tone perspective drawings by
// computer", 1967; J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "raster/fill/polygon.h"
#include "raster/path/exact_area.h"
#include "raster/path/path.h"
#include "raster/pixel_rect.h"
#include "raster/scan/row_span.h"

namespace kinescope {

/// An edge that the scan line crosses. Where it crosses is kept as a whole column and an exact
/// fraction, stepped from row to row.
struct ActiveEdge {
  int column = 0;              ///< the first pixel whose centre lies right of the edge, or on it
  int direction = 0;           ///< 1 where the edge goes down, -1 where up
  int y_end = 0;               ///< the row behind its last
  std::uint32_t edge = 0;      ///< its number, in the order of adding
  std::int64_t remainder = 0;  ///< of the denominator: how far column lies beyond the crossing
  std::int64_t step_rest = 0;  ///< what a row takes of the remainder,
  int step = 0;                ///< and of columns
  std::int64_t denominator = 1;
};

/// Yields the pixels whose centres lie inside, row by row. Corners are rounded to 1/256 pixel, and
/// from there on all is exact: polygons that share an edge neither overlap nor leave a gap. An edge
/// owns the centres at its upper end and not those at its lower: corners count rightly, level edges
/// not at all.
class ScanlineFill {
 public:
  static constexpr int kLargestCoordinate = 1 << 21;

  /// Only what lies within the window costs anything. @throws Error (bad input) if the window
  /// reaches beyond kLargestCoordinate
  ScanlineFill(const PixelRect& window, FillRule rule);

  /// Contours must be closed by the caller. An edge that is not finite is left out.
  /// @throws Error (bad input) beyond kLargestCoordinate
  void add_edge(glm::dvec2 from, glm::dvec2 to);
  void add(const Polygon& polygon);

  /// Moves to the next row that has edges (at first: to the first); false behind the last.
  bool next();
  int y() const { return y_; }
  /// This row's runs of pixels, from the left; none is empty, no two touch.
  std::span<const RowSpan> spans() const { return spans_; }
  /// This row's edges from left to right.
  std::size_t active_count() const { return order_.size(); }
  const ActiveEdge& active(std::size_t i) const {
    return active_[static_cast<std::uint32_t>(order_[i])];
  }
  /// Edges that still wait for their first row.
  std::size_t waiting() const { return (begun_ ? by_row_.size() : edges_.size()) - next_edge_; }

 private:
  struct Edge {  // in 1/256 pixel, downwards
    std::int32_t x0, y0, x1, y1;
    std::int32_t row;
    std::int32_t direction;
  };

  void begin();
  void advance();
  void activate(std::uint32_t index);
  void sort();
  void sort_by_digits();
  void find_spans();

  PixelRect window_;
  FillRule rule_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> by_row_;  // edges in the order of their first rows: the edge table
  std::size_t next_edge_ = 0;
  std::vector<ActiveEdge> active_;
  std::vector<std::uint64_t> order_;  // column, then place in active_
  std::vector<std::uint64_t> sorted_;
  std::vector<RowSpan> spans_;
  int y_ = 0;
  bool begun_ = false;
};

/// Calls sink(RowSpan) for each run, from the top.
template <typename Sink>
void scanline_fill(const Polygon& polygon, FillRule rule, const PixelRect& window, Sink&& sink) {
  ScanlineFill fill(window, rule);
  fill.add(polygon);
  while (fill.next()) {
    for (const RowSpan& span : fill.spans()) sink(span);
  }
}

/// The same for a region bounded by curves, which are cut into chords no further than the tolerance
/// from them.
template <typename Sink>
void scanline_fill(const Path& path, const PixelsFromPath& place, float tolerance_px, FillRule rule,
                   const PixelRect& window, Sink&& sink) {
  ScanlineFill fill(window, rule);
  path_edges(path, place, tolerance_px,
             [&](glm::dvec2 from, glm::dvec2 to) { fill.add_edge(from, to); });
  while (fill.next()) {
    for (const RowSpan& span : fill.spans()) sink(span);
  }
}

}  // namespace kinescope
