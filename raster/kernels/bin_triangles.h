// The front end's second step: small and medium triangles to the tiles that they touch.
#pragma once

#include <cstdint>

#include "raster/bins.h"
#include "raster/kernels/cull.h"

namespace kinescope {

/// @param first_id  id of the call's first triangle
void bin_pixels(const CulledTriangles::Pixels& pixels, std::uint32_t first_id, const TileGrid& grid,
                Bins& bins);
/// @param limits  of the samples' places in a pixel
void bin_small_triangles(const CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                         const SampleLimits& limits, const TileGrid& grid, Bins& bins);
void bin_medium_triangles(const CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                          const SampleLimits& limits, const TileGrid& grid, Bins& bins);

}  // namespace kinescope
