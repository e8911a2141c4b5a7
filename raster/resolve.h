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

/// Copies the depth of each pixel's first sample. All blocks must be stored.
void keep_depth(const TileBuffer& tile, Image<float>& depth);

}  // namespace kinescope
