// Draws large triangles in one tile, block by block.
#pragma once

#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// Visibility of the records' samples in the tile. Cheapest with the nearest first: blocks that one
/// covers hide what lies behind it.
void draw_large_triangles(std::span<const TriangleRecord* const> records,
                          std::span<const SampleOffset> pattern, TileBuffer& tile);

/// Stores the samples of all blocks, for those who look at each.
void store_all_blocks(std::span<const SampleOffset> pattern, TileBuffer& tile);

}  // namespace kinescope
