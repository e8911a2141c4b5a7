// Keeps the pixels of a draw call within its scissor.
#pragma once

#include <span>

#include "raster/draw_call.h"
#include "raster/kernels/cull.h"
#include "raster/sample_pattern.h"
#include "raster/tile_grid.h"

namespace kinescope {

/// The pixels that a call may touch.
PixelRect clip_of(const DrawCall& call, const TileGrid& grid);

/// Leaves as small and medium only triangles that lie within the clip; drops those that miss it;
/// makes the others large ones, whose records carry a box of pixels.
void apply_scissor(const PixelRect& clip, std::span<const SampleOffset> pattern,
                   CulledTriangles& triangles);

}  // namespace kinescope
