// What a display processor asks of the beam.
#pragma once

#include <array>

#include "display/vector/display_memory.h"
#include "raster/base/units.h"

namespace kinescope {

/// An even motion from one place to another, or a rest where both are the same. Device units, y
/// upwards. Between moves the beam rests, dark.
struct BeamMove {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  Seconds begin{0}, end{0};
  float intensity = 0;                   ///< 0 is dark, 1 the full current
  std::array<float, 3> colour{1, 1, 1};  ///< share of each gun; of a penetration tube see there
  Address address = 0;                   ///< of the instruction
  float spread = 1;                      ///< times the spot's usual width: above 1 out of focus
};

}  // namespace kinescope
