#include "raster/visibility_hash.h"

#include <bit>

namespace kinescope {
namespace {

/// Source: the finaliser of SplitMix64, G. Steele et al., "Fast splittable pseudorandom number
/// generators", OOPSLA 2014.
std::uint64_t mix(std::uint64_t v) {
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
  return v ^ (v >> 31);
}

}  // namespace

std::uint64_t sample_hash(std::uint64_t sample_index, std::uint32_t id, float depth) {
  if (id == TileBuffer::kNothing) return 0;
  const std::uint64_t shown = std::uint64_t{id} << 32 | std::bit_cast<std::uint32_t>(depth);
  return mix(mix(sample_index + 0x9e3779b97f4a7c15u) ^ shown);
}

std::uint64_t tile_hash(const TileBuffer& tile, int target_width) {
  std::uint64_t sum = 0;
  const auto samples = static_cast<std::uint64_t>(tile.samples);
  for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
    const std::uint64_t pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(target_width) +
        static_cast<std::uint64_t>(tile.rect.x0);
    const auto row = static_cast<std::size_t>(y - tile.rect.y0) *
                     static_cast<std::size_t>(tile.stride) * samples;
    const std::uint64_t count = samples * static_cast<std::uint64_t>(tile.rect.x1 - tile.rect.x0);
    for (std::uint64_t i = 0; i < count; ++i) {
      sum += sample_hash(pixel * samples + i, tile.id[row + i], tile.depth[row + i]);
    }
  }
  return sum;
}

}  // namespace kinescope
