// Triangles of middle size in one tile: set up SIMD across triangles, drawn eight pixels at a time.
#pragma once

#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// Visibility of the triangles' samples in the tile, and beyond the target's right edge too.
void draw_medium_triangles(const ChunkList<TriangleChunk>& triangles,
                           std::span<const SampleOffset> pattern, TileBuffer& tile);

}  // namespace kinescope
