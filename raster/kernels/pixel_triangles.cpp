#include "raster/kernels/pixel_triangles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/pixel_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/merge_fragments-inl.h"
#include "raster/kernels/prefetch-inl.h"
#include "raster/kernels/tile_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {

void DrawPixels(const ChunkList<PixelChunk>& pixels, std::span<const SampleOffset> pattern,
                TileBuffer& tile) {
  const LaneParts<1> parts(pattern);
  float* const depth = tile.depth.data();
  std::uint32_t* const id = tile.id.data();
  for (const PixelChunk* chunk = pixels.first; chunk != nullptr; chunk = chunk->next) {
    prefetch(chunk->next, 0, 1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk->size); ++i) {
      const int x = static_cast<int>(chunk->place[i] & 255),
                y = static_cast<int>(chunk->place[i] >> 8);
      const int block = (y >> 3) * tile.block_columns + (x >> 3);
      if (!tile.is_stored(block)) store_block(block, parts, tile);
      test_pixel(chunk->z[i], chunk->id[i], static_cast<std::size_t>(y * tile.stride + x), depth,
                 id);
    }
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawPixels);

void draw_pixels(const ChunkList<PixelChunk>& pixels, std::span<const SampleOffset> pattern,
                 TileBuffer& tile) {
  if (pixels.first == nullptr) return;
  HWY_DYNAMIC_DISPATCH(DrawPixels)(pixels, pattern, tile);
}

}  // namespace kinescope
#endif
