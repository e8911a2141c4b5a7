// Many strokes and spots of the beam onto a picture, on all workers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display/vector/beam_stroke.h"
#include "display/vector/tiled_light.h"
#include "raster/base/workers.h"

namespace kinescope {

/// Adds marks in the order given: the light is the same for any number of workers. Keeps its
/// memory from call to call.
class BeamPainter {
 public:
  /// Marks that are not finite are left out; what lies outside the picture is clipped, in place,
  /// its light lost as it is beside a screen.
  /// @param chunks sorted apart from each other: some for each worker
  void draw(std::span<BeamMarks> chunks, TiledLight& light, Workers& workers);
  /// The same of plain strokes.
  /// @param weights for each stroke one for each plane of `light`
  void draw(std::span<const BeamStroke> strokes, std::span<const float> weights, TiledLight& light,
            Workers& workers);

 private:
  struct Tiles {
    std::uint16_t left, top, right, bottom;  // right and bottom are not within
  };
  struct Chunk {
    std::vector<Tiles> boxes;           // of each mark
    std::vector<std::uint32_t> starts;  // of each tile in the order
    std::vector<std::uint32_t> order;   // marks' numbers, tile by tile
  };
  static void sort(BeamMarks& marks, const TiledLight& light, Chunk& chunk);

  std::vector<BeamMarks> plain_;  // chunks of strokes
  std::vector<Chunk> chunks_;
};

}  // namespace kinescope
