// Draws one triangle in one tile: every row a span whose ends are exact.
#pragma once

#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// Visibility of the records' samples in the tile. Cheapest with the nearest first: one that covers
/// the tile hides what lies behind it.
void draw_records(std::span<const TriangleRecord* const> records,
                  std::span<const SampleOffset> pattern, TileBuffer& tile);

}  // namespace kinescope
