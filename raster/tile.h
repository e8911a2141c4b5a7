// The samples of the tile being drawn: depth, and which triangle is visible.
#pragma once

#include <cstdint>

#include "raster/aligned_vector.h"
#include "raster/bins.h"

namespace kinescope {

/// Rows of tile_width pixels, the samples of a pixel side by side; what lies beyond the target's
/// edge is not looked at.
struct TileBuffer {
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  PixelRect rect;  ///< of the target's pixels
  int stride = 0;  ///< pixels of a row
  int pixels = 0;  ///< of the whole tile
  int samples = 1;
  float farthest = 1;               ///< no sample shows anything beyond this depth
  AlignedVector<float> depth;       ///< 1 where nothing is visible
  AlignedVector<std::uint32_t> id;  ///< kNothing there

  /// Empties the buffer for a tile.
  void begin(const TileGrid& grid, int tile, int sample_count);
};

/// Depth-tests finished fragments of pixels with one sample.
void merge_fragments(const ChunkList<FragmentChunk>& fragments, TileBuffer& tile);

}  // namespace kinescope
