#include "raster/tile.h"

#include <algorithm>
#include <limits>

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
  block_columns = grid.tile_width / kBlock;
  block_rows = grid.tile_height / kBlock;
  stored = 0;
  shown.fill(nullptr);
  block_nearest.fill(std::numeric_limits<float>::infinity());
  // Those that the tile does not have are never the farthest.
  block_farthest.fill(0.0f);
  std::fill_n(block_farthest.begin(), block_columns * block_rows, 1.0f);
}

PixelRect TileBuffer::block_rect(int block) const {
  const int x = rect.x0 + block % block_columns * kBlock;
  const int y = rect.y0 + block / block_columns * kBlock;
  return {x, y, std::min(x + kBlock, rect.x1), std::min(y + kBlock, rect.y1)};
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
