// How the lines of one vertical sweep lie, compared with a raster that is where it should be.
#pragma once

#include <vector>

#include "display/tube/beam_map.h"

namespace kinescope {

struct SweepWarp {
  std::vector<float> place;  ///< of each line: the line of the steady raster that it lies on
  std::vector<float> scale;  ///< how much wider it is
  std::vector<float> shift;  ///< how far to the right its middle lies, cells
};

/// The steady raster's map, of lines with `cells` each, as the sweep's lines have it.
BeamMap warped(const BeamMap& steady, const SweepWarp& warp, int cells, int tile_columns);

}  // namespace kinescope
