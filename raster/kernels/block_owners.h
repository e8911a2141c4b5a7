// Which triangles own the pixels of a block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/tile.h"

namespace kinescope {

/// The few triangles that share a block's 64 pixels among them.
struct BlockOwners {
  static constexpr std::size_t kMax = 5;

  std::size_t size = 0;
  std::array<std::uint32_t, kMax> id;
  std::array<std::uint64_t, kMax> pixels;  ///< a bit each, row by row
};

/// Finds the owners of a block that lies within the target. False if there are more than kMax, if
/// a pixel shows nothing, or not one triangle at all of its samples.
bool find_owners(const TileBuffer& tile, int block, BlockOwners& out);

}  // namespace kinescope
