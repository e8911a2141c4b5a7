// Samples to pixels: averaged in linear light, then encoded to the target's format.
#pragma once

#include <span>

#include "raster/render_target.h"
#include "raster/tile.h"
#include "raster/visible_fragments.h"

namespace kinescope {

/// Writes the pixels of those blocks of a tile whose fragments these are.
/// @param colours  of the fragments
void resolve_blocks(const TileBuffer& tile, const VisibleFragments& fragments,
                    std::span<const LinearRgba> colours, RenderTarget& target);

/// Writes a block that lies within the target, from the colours of its pixels.
void write_whole_block(std::span<const LinearRgba, TileBuffer::kBlockPixels> colours, int x0,
                       int y0, RenderTarget& target);

/// Copies the depth of each pixel's first sample. All blocks must be stored.
void keep_depth(const TileBuffer& tile, Image<float>& depth);

}  // namespace kinescope
