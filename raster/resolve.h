// Samples to pixels: averaged in linear light, then encoded to the target's format.
#pragma once

#include <span>

#include "raster/aligned_vector.h"
#include "raster/render_target.h"
#include "raster/tile.h"
#include "raster/visible_fragments.h"

namespace kinescope {

/// Writes a tile's pixels, and its depth if the target keeps it. `colours` are the fragments'.
/// @param row a worker's storage for one row of pixels
void resolve_tile(const TileBuffer& tile, const VisibleFragments& fragments,
                  std::span<const LinearRgba> colours, AlignedVector<LinearRgba>& row,
                  RenderTarget& target);

}  // namespace kinescope
