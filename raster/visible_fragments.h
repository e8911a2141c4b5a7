// The fragments of a tile that are to be shaded: one a pixel and triangle, in screen order.
#pragma once

#include <array>
#include <cstdint>

#include "raster/aligned_vector.h"
#include "raster/tile.h"

namespace kinescope {

/// Structure of arrays, `size` entries each; the arrays only grow.
struct VisibleFragments {
  int size = 0;
  AlignedVector<std::uint32_t> id;
  AlignedVector<std::uint32_t> xy;     ///< pixel in the target: x in the low half, y in the high
  AlignedVector<std::uint8_t> weight;  ///< samples it covers in its pixel; unset at one sample
  /// The first fragment of each row of the tile, and one entry more.
  std::array<int, TileGrid::kMaxTile + 1> row_first{};
  /// Whether each pixel of a row shows one triangle at all of its samples.
  std::array<bool, TileGrid::kMaxTile> row_is_whole{};

  void reserve(int count);
};

}  // namespace kinescope
