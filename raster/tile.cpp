#include "raster/tile.h"

#include <algorithm>
#include <array>

namespace kinescope {

void TileBuffer::begin(const TileGrid& grid, int tile, int sample_count) {
  rect = grid.rect(tile);
  stride = grid.tile_width;
  pixels = grid.tile_width * grid.tile_height;
  samples = sample_count;
  farthest = 1;
  const auto total = static_cast<std::size_t>(pixels) * static_cast<std::size_t>(samples);
  depth.resize(total);
  id.resize(total);
  // Blocks of known size: these loops become vector stores. Tiles hold whole blocks.
  constexpr std::size_t kBlock = 16;
  std::array<float, kBlock> far;
  std::array<std::uint32_t, kBlock> nothing;
  far.fill(1.0f);
  nothing.fill(kNothing);
  for (std::size_t i = 0; i < total; i += kBlock) {
    std::copy_n(far.data(), kBlock, depth.data() + i);
    std::copy_n(nothing.data(), kBlock, id.data() + i);
  }
}

void merge_fragments(const ChunkList<FragmentChunk>& fragments, TileBuffer& tile) {
  float* const depth = tile.depth.data();
  std::uint32_t* const id = tile.id.data();
  for (const FragmentChunk* chunk = fragments.first; chunk != nullptr; chunk = chunk->next) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk->size); ++i) {
      const std::uint32_t place = chunk->pixel[i];
      const float z = chunk->depth[0][i], old_z = depth[place];
      const std::uint32_t triangle = chunk->id[i];
      // Written either way: a store costs less than a branch that nobody can predict.
      const bool wins = (z < old_z) | ((z == old_z) & (triangle < id[place]));
      depth[place] = wins ? z : old_z;
      id[place] = wins ? triangle : id[place];
    }
  }
}

}  // namespace kinescope
