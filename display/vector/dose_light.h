// What a dose of the beam is worth on each plane of a vector tube's light.
#pragma once

#include <array>
#include <vector>

#include "display/phosphor.h"
#include "raster/base/units.h"

namespace kinescope {

/// A layer of the faceplate and its planes: the light of this exposure, then for each term of its
/// phosphor the light to come.
struct LightLayer {
  Phosphor phosphor;
  std::array<float, 3> colour;
  std::size_t gun;
  int first_plane;
};

/// Adds a weight for each plane, of a dose spread evenly over [begin, end), in the exposure that
/// ends at `until`, not before `end`.
/// @param guns share of each; a layer takes that of its own
void add_dose_weights(const std::vector<LightLayer>& layers, double dose,
                      const std::array<float, 3>& guns, Seconds begin, Seconds end, Seconds until,
                      std::vector<float>& weights);

}  // namespace kinescope
