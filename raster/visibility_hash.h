// A number that two frames share if the same triangle, at the same depth, shows at every sample.
#pragma once

#include <cstdint>

#include "raster/tile.h"

namespace kinescope {

/// What one sample adds to the hash: 0 where nothing shows. `sample_index` is
/// (y * width + x) * samples + s. The hash is the sum, so any order of tiles gives the same.
std::uint64_t sample_hash(std::uint64_t sample_index, std::uint32_t id, float depth);

/// The sum over a tile of a target of this width.
std::uint64_t tile_hash(const TileBuffer& tile, int target_width);

}  // namespace kinescope
