// The loops that spread a line's light across the output's columns, and lines down its rows.
// Columns are taken in groups of kGroup; rows of columns are padded to whole groups.
#pragma once

#include <cstdint>
#include <span>

#include "raster/colour/colour.h"

namespace kinescope {

constexpr int kGroup = 8;     ///< columns
constexpr int kCellPad = 16;  ///< dark cells that lie before and after a line's
constexpr int kLineTaps = 4;  ///< lines near a row, where the raster is curved
constexpr int kCellTaps = 6;  ///< cells near a column, likewise

/// Light of a line's cells by the narrow and the wide Gaussian; cell 0 first, padded on both sides.
struct CellRows {
  const float* narrow;
  const float* wide;
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
  bool close;  ///< the cells at which a group's columns start lie within a vector
};
void spread_across(const AcrossTable& table, CellRows cells, SpreadRows out);

/// Where columns lie on a curved line: cell[i] at column i * kGroup, of groups + 1 such nodes.
struct AcrossCurve {
  const float* cell;  ///< cells from the line's beginning
  int groups;
  int cells;                         ///< in the line
  float cells_a_pixel;               ///< the mean, of which the light of white is 1
  float narrow_pixels, wide_pixels;  ///< standard deviations, with the pixel's own
};
void spread_across_curve(const AcrossCurve& curve, CellRows cells, SpreadRows out);

/// out = the sum over taps of weight times row.
void spread_down(int groups, int taps, const float* const* narrow_rows,
                 const float* const* wide_rows, const float* narrow_weight,
                 const float* wide_weight, float* out);

/// Where a row of columns lies among curved lines, and the lines spread so far, in a ring.
struct DownCurve {
  const float* line;   ///< at each node, in lines: a whole number is the middle of a line
  const float* pitch;  ///< lines a row, in each group
  int groups;
  float lines_a_pixel;  ///< the mean, of which the light of white is 1
  float narrow_pixels, wide_pixels;
  const float* narrow_ring;  ///< line l at (l & ring_mask) * ring_pitch
  const float* wide_ring;
  int ring_mask, ring_pitch;
};
void spread_down_curve(const DownCurve& curve, float* out);

/// What becomes of the guns' light on its way out of the glass, in one row. Rows of three, a gun
/// or a colour each.
struct FinishRow {
  const float* light[3];
  const std::uint8_t* mask[3];  ///< transmission in 1/64, or null
  const float* glow[3];         ///< of halation, low rows above and below; or null
  const float* glow_below[3];
  float glow_share;    ///< of glow_below
  float colour[3][3];  ///< of each gun, by its light
  int guns;            ///< 1 or 3
  float ambient[3];
};
/// n pixels; `add` to what is there, or replace it.
void finish_light(const FinishRow& row, int n, bool add, LinearRgb* out);
/// n pixels of light times gain, encoded by the sRGB curve within half a code.
void finish_encoded(const FinishRow& row, int n, float gain, Srgb8* out);

}  // namespace kinescope
