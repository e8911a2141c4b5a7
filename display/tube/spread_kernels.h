// The loops that spread a line's light across the output's columns, and lines down its rows.
// Columns are taken in groups of kGroup; rows of columns are padded to whole groups.
#pragma once

namespace kinescope {

constexpr int kGroup = 8;     ///< columns
constexpr int kCellPad = 16;  ///< dark cells that lie before and after a line's
constexpr int kLineTaps = 4;  ///< lines near a row, where the raster is curved
constexpr int kCellTaps = 6;  ///< cells near a column, likewise

/// Light of a line's cells by the narrow and the wide Gaussian; cell 0 first, padded on both sides.
struct CellRows {
  const float* narrow;
  const float* wide;
  int next_line;  ///< floats from here to the cells of the line that will be spread next
};
/// A line spread over columns.
struct SpreadRows {
  float* narrow;
  float* wide;
};

/// Weights of columns [0, groups * kGroup): weight[tap * pitch + column].
struct AcrossTable {
  const int* start;
  const float* narrow;
  const float* wide;
  int taps, pitch, groups;
  int span;  ///< the most cells from where a group's first column starts to where its last does
};
void spread_across(const AcrossTable& table, CellRows cells, SpreadRows out);

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

/// out = the sum over taps of weight times row, or `add` it to what is there.
void spread_down(int groups, int taps, const float* const* narrow_rows,
                 const float* const* wide_rows, const float* narrow_weight,
                 const float* wide_weight, bool add, float* out);

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
/// Of each group: its first line, and the weights of kLineTaps lines, kGroup columns each.
struct LineWeights {
  const int* base;
  const float *narrow, *wide;
};
void find_line_weights(const LineGrid& grid, int* base, float* narrow, float* wide);

/// Lines spread across columns: line l at (l & mask) * pitch.
struct LineRing {
  const float *narrow, *wide;
  int mask, pitch;
};
void spread_down_curve(int groups, const LineWeights& weights, const LineRing& ring, float* out);

}  // namespace kinescope
