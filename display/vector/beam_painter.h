// Many strokes of the beam onto a picture, on all workers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display/vector/beam_stroke.h"
#include "display/vector/tiled_light.h"
#include "raster/base/workers.h"

namespace kinescope {

/// Adds strokes in the order given: the light is the same for any number of workers. Keeps its
/// memory from call to call.
class BeamPainter {
 public:
  /// Strokes that are not finite are left out; what lies outside the picture is clipped, its light
  /// lost as it is beside a screen.
  /// @param weights for each stroke one for each plane of `light`
  void draw(std::span<const BeamStroke> strokes, std::span<const float> weights, TiledLight& light,
            Workers& workers);

 private:
  struct Tiles {
    std::uint16_t left, top, right, bottom;  // right and bottom are not within
  };
  void clip(std::span<const BeamStroke> strokes, std::span<const float> weights,
            const TiledLight& light);
  void sort(const TiledLight& light, Workers& workers);

  std::vector<BeamStroke> clipped_;
  std::vector<float> clipped_weights_;
  std::vector<std::uint32_t> far_;  // strokes that leave the picture's surroundings
  std::span<const BeamStroke> strokes_;
  std::span<const float> weights_;
  std::vector<Tiles> boxes_;
  std::vector<std::uint32_t> starts_;  // of each tile, and of each chunk of strokes in it
  std::vector<std::uint32_t> order_;   // strokes' numbers, tile by tile
};

}  // namespace kinescope
