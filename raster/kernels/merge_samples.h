// Depth-tests finished fragments of pixels with several samples.
#pragma once

#include "raster/bins.h"
#include "raster/tile.h"

namespace kinescope {

void merge_samples(const ChunkList<SampledChunk>& fragments, TileBuffer& tile);

}  // namespace kinescope
