// Triangles that cover one pixel, finished when they were culled.
#pragma once

#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// Visibility of the pixels in their tile.
/// @param pattern  of one sample
void draw_pixels(const ChunkList<PixelChunk>& pixels, std::span<const SampleOffset> pattern,
                 TileBuffer& tile);

}  // namespace kinescope
