// The fragments of a tile that are to be shaded: one a pixel and triangle, in screen order.
#pragma once

#include <cstdint>

#include "raster/aligned_vector.h"
#include "raster/tile.h"

namespace kinescope {

/// Structure of arrays, `size` entries each; the arrays only grow.
struct VisibleFragments {
  int size = 0;
  AlignedVector<std::uint32_t> id;
  AlignedVector<std::uint16_t> x, y;   ///< pixel in the target
  AlignedVector<std::uint8_t> weight;  ///< samples it covers in its pixel

  void reserve(int count);
};

/// Finds the visible triangles of each pixel; of one pixel, in the order of its samples.
void gather_visible(const TileBuffer& tile, VisibleFragments& out);

}  // namespace kinescope
