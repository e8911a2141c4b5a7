// Finds what is visible in a tile.
#pragma once

#include "raster/visible_fragments.h"

namespace kinescope {

/// The visible triangles of each pixel; of one pixel, in the order of its samples.
void gather_visible(const TileBuffer& tile, VisibleFragments& out);

}  // namespace kinescope
