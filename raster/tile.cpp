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
  stored = stale = 0;
  shown.fill(nullptr);
  drawn.fill(0);
  block_nearest.fill(std::numeric_limits<float>::infinity());
  // Blocks beyond the target are never the farthest.
  block_farthest.fill(0.0f);
  const int columns = (rect.x1 - rect.x0 + kBlock - 1) / kBlock;
  for (int y = rect.y0, first = 0; y < rect.y1; y += kBlock, first += block_columns) {
    std::fill_n(block_farthest.begin() + first, columns, 1.0f);
  }
}

PixelRect TileBuffer::block_rect(int block) const {
  const int x = rect.x0 + block % block_columns * kBlock;
  const int y = rect.y0 + block / block_columns * kBlock;
  return {x, y, std::min(x + kBlock, rect.x1), std::min(y + kBlock, rect.y1)};
}

}  // namespace kinescope
