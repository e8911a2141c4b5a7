// Finds what is visible in a tile.
#pragma once

#include "raster/visible_fragments.h"

namespace kinescope {

/// The visible triangles of each pixel, of one pixel in the order of its samples: of the tile's
/// block `first_block` and as many more as one batch may hold.
void gather_visible(const TileBuffer& tile, int first_block, VisibleFragments& out);

}  // namespace kinescope
