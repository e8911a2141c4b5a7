// The loops that spread the light of curved lines: across columns, and down rows. The lines' places
// are known at the nodes of a grid, kGroup pixels apart.
#pragma once

#include <span>

#include "display/tube/spread_kernels.h"

namespace kinescope {

constexpr int kLineTaps = 4;  ///< lines near a row
constexpr int kCellTaps = 6;  ///< cells near a column, at most

/// Where columns lie on a curved line: cell[i] at column i * kGroup, of groups + 1 such nodes.
struct AcrossCurve {
  const float* cell;  ///< cells from the line's beginning
  int groups;
  int cells;                         ///< in the line
  int taps;                          ///< cells near a column: 4, 5 or 6
  float cells_a_pixel;               ///< the mean, of which the light of white is 1
  float narrow_pixels, wide_pixels;  ///< standard deviations, with the pixel's own
};
void spread_across_curve(const AcrossCurve& curve, CellRows cells, SpreadRows out);

/// Where a row of columns lies among curved lines.
struct LineGrid {
  /// Lines at the nodes of the grid's rows above and below, a whole number being the middle of a
  /// line; and how far down between the two, which lie kGroup rows apart.
  const float *above, *below;
  float share;
  int groups;
  float least_pitch;    ///< lines a row: the raster is nowhere stretched further than that
  float lines_a_pixel;  ///< the mean, of which the light of white is 1
  float narrow_pixels, wide_pixels;  ///< standard deviations
};
/// Lines spread across columns: line l at (l & mask) * pitch.
struct LineRing {
  int mask, pitch;
};
/// Those of one layer, and where their row goes.
struct LineRows {
  const float *narrow, *wide;
  float* out;
};
/// @param rows one, or two or three that share the grid: lines are weighed but once
void spread_down_curve(const LineGrid& grid, const LineRing& ring, std::span<const LineRows> rows);

}  // namespace kinescope
