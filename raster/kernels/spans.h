// Draws one triangle in one tile: every row a span whose ends are exact.
#pragma once

#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// Visibility of the records' samples in the tile.
void draw_records(std::span<const TriangleRecord> records, std::span<const SampleOffset> pattern,
                  TileBuffer& tile);

}  // namespace kinescope
