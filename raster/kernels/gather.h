// Finds what is visible in a tile.
#pragma once

#include <cstdint>

#include "raster/visible_fragments.h"

namespace kinescope {

/// The visible triangles of each pixel, of one pixel in the order of its samples: of as many of the
/// tile's blocks as one batch may hold.
/// @param blocks  a bit each, one at least
/// @return those that are left
std::uint64_t gather_visible(const TileBuffer& tile, std::uint64_t blocks, VisibleFragments& out);

}  // namespace kinescope
