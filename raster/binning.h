// Larger triangles go as records into the bins of the tiles they touch.
#pragma once

#include <cstdint>
#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/triangle_setup.h"

namespace kinescope {

/// The pixels whose samples a box of raw 24.8 coordinates may hold, cut to the target.
PixelRect pixel_box(const SnappedTriangle& triangle, std::span<const SampleOffset> pattern,
                    const TileGrid& grid);

/// Puts a triangle's record into each tile where it may cover a sample. Returns whether any.
/// @param clip  within the target: no pixel outside is drawn
bool bin_triangle(const SnappedTriangle& triangle, std::uint32_t id,
                  std::span<const SampleOffset> pattern, const PixelRect& clip,
                  const TileGrid& grid, std::span<ChunkList<RecordChunk>> tiles,
                  ChunkPool<RecordChunk>& pool);

}  // namespace kinescope
