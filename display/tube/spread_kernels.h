// The loops that spread a line's light across the output's columns, and lines down its rows.
// Columns are taken in groups of kGroup; rows of columns are padded to whole groups.
#pragma once

namespace kinescope {

constexpr int kGroup = 8;     ///< columns
constexpr int kCellPad = 16;  ///< dark cells that lie before and after a line's

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

/// out = the sum over taps of weight times row, or `add` it to what is there.
void spread_down(int groups, int taps, const float* const* narrow_rows,
                 const float* const* wide_rows, const float* narrow_weight,
                 const float* wide_weight, bool add, float* out);

}  // namespace kinescope
