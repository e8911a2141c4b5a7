// Small triangles, SIMD across them, straight to fragments in the tiles' bins.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/bins.h"
#include "raster/kernels/cull.h"
#include "raster/sample_pattern.h"

namespace kinescope {

/// Appends the fragments of all small triangles. Writes over the padding of `triangles`.
/// @param first_id  id of the call's first triangle
void draw_small_triangles(CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                          std::span<const SampleOffset> pattern, const TileGrid& grid, Bins& bins);

}  // namespace kinescope
