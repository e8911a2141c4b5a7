// How the lines of one vertical sweep lie, compared with a raster that is where it should be.
#pragma once

#include <vector>

#include "display/tube/beam_map.h"
#include "display/tube/free_sweep.h"

namespace kinescope {

/// How the deflection is disturbed at a moment.
struct SweepBend {
  double scale = 1;                 ///< about the middle
  double shift_x = 0, shift_y = 0;  ///< shares of half the picture
};
/// @param load that the high voltage feels, of steady white's
SweepBend sweep_bend(const SweepSettings& settings, double seconds, double load);
/// The high voltage's share that is left at a load.
double voltage_at(const SweepSettings& settings, double load);

struct SweepWarp {
  std::vector<float> place;  ///< of each line: the line of the steady raster that it lies on
  std::vector<float> scale;  ///< how much wider it is
  std::vector<float> shift;  ///< how far to the right its middle lies, cells
};

/// Places a field's line; `cells` in each of so many lines.
void bend_line(SweepWarp& warp, const SweptField& field, int line, const SweepBend& bend, int cells,
               int lines);

/// The steady raster's map, of lines with `cells` each, as the sweep's lines have it.
BeamMap warped(const BeamMap& steady, const SweepWarp& warp, int cells, int tile_columns);

}  // namespace kinescope
