// What the front end leaves for each tile: records of triangles and finished fragments.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "raster/tile_grid.h"
#include "raster/triangle_setup.h"

namespace kinescope {

/// A triangle to be drawn in a tile.
struct TriangleRecord {
  std::array<std::int32_t, 3> x, y;  ///< raw Fixed24_8, positive area
  std::uint32_t id;                  ///< order of submission in the frame
  float z, dz_dx, dz_dy;             ///< DepthPlane; its anchor is `anchor_x`, `anchor_y`
  float nearest, farthest;
  std::int16_t x0, y0, x1, y1;  ///< box in pixels, half open, within the target
  bool clipped = false;         ///< the box cuts the triangle: samples outside it are not covered
};
static_assert(sizeof(TriangleRecord) <= 64);

/// A small or medium triangle in a tile, in one half of a cache line, so that to append it touches
/// one. Words 0 to 2 are its corners' raw Fixed24_8 from the tile's first pixel, y << 16 | x, both
/// signed; they fit, since a medium triangle reaches less than 64 pixels beyond a tile of at most
/// 64. Words 3 to 5 are their depths' bits, word 6 is its id, the last is not used.
struct alignas(32) BinnedTriangle {
  std::array<std::uint32_t, 8> word;
};

/// Of an odd number of cache lines, lest chunks compete for the same places in a cache.
struct alignas(64) TriangleChunk {
  static constexpr std::size_t kCapacity = 24;
  TriangleChunk* next;
  int size;
  alignas(64) std::array<BinnedTriangle, kCapacity> triangle;
};

/// Triangles that cover one pixel, at one sample a pixel.
struct PixelChunk {
  static constexpr std::size_t kCapacity = 64;
  std::array<std::uint32_t, kCapacity> place;  ///< row << 8 | column in the tile
  std::array<float, kCapacity> z;
  std::array<std::uint32_t, kCapacity> id;
  PixelChunk* next;
  int size;
};

struct RecordChunk {
  static constexpr int kCapacity = 15;
  std::array<TriangleRecord, kCapacity> records;
  RecordChunk* next;
  int size;
};

/// Hands out chunks and takes them all back at once; memory is kept for the next frame.
template <typename Chunk>
class ChunkPool {
 public:
  Chunk* take() {
    if (used_ == blocks_.size() * kBlock) {
      blocks_.push_back(std::make_unique_for_overwrite<Chunk[]>(kBlock));
    }
    Chunk* chunk = &blocks_[used_ / kBlock][used_ % kBlock];
    ++used_;
    chunk->next = nullptr;
    chunk->size = 0;
    return chunk;
  }
  /// Asks for the memory of the chunk that will be taken next: of a mesh's stream of triangles,
  /// most of the cost of binning is to wait for it.
  void prefetch_next() const {
    if (used_ == blocks_.size() * kBlock) return;
    const auto* const next =
        reinterpret_cast<const std::byte*>(&blocks_[used_ / kBlock][used_ % kBlock]);
    for (std::size_t n = 0; n < sizeof(Chunk); n += 64) __builtin_prefetch(next + n, 1);
  }
  void take_all_back() { used_ = 0; }

 private:
  static constexpr std::size_t kBlock = 64;
  std::vector<std::unique_ptr<Chunk[]>> blocks_;
  std::size_t used_ = 0;
};

/// A list of chunks in the order they were filled.
template <typename Chunk>
struct ChunkList {
  Chunk* first = nullptr;
  Chunk* last = nullptr;

  /// The last chunk, with room for at least `room` more.
  Chunk& tail(ChunkPool<Chunk>& pool, int room = 1) {
    if (last == nullptr || last->size + room > static_cast<int>(Chunk::kCapacity)) [[unlikely]]
      grow(pool);
    return *last;
  }

 private:
  [[gnu::noinline]] void grow(ChunkPool<Chunk>& pool) {
    Chunk* const chunk = pool.take();
    if (last != nullptr) pool.prefetch_next();
    (last == nullptr ? first : last->next) = chunk;
    last = chunk;
  }
};

/// One worker's bins, a list a tile: no worker waits for another. Since the nearest fragment wins,
/// and of equals the one submitted first, the order in which bins are drawn does not matter.
struct Bins {
  std::vector<ChunkList<RecordChunk>> records;
  std::vector<ChunkList<TriangleChunk>> medium;
  std::vector<ChunkList<PixelChunk>> pixels;
  std::vector<ChunkList<TriangleChunk>> small;         ///< those that touch no other tile
  std::vector<ChunkList<TriangleChunk>> small_across;  ///< the others
  ChunkPool<RecordChunk> record_pool;
  ChunkPool<TriangleChunk> triangle_pool;
  ChunkPool<PixelChunk> pixel_pool;

  void clear(int tiles) {
    records.assign(static_cast<std::size_t>(tiles), {});
    for (auto* lists : {&medium, &small, &small_across}) {
      lists->assign(static_cast<std::size_t>(tiles), {});
    }
    pixels.assign(static_cast<std::size_t>(tiles), {});
    record_pool.take_all_back();
    pixel_pool.take_all_back();
    triangle_pool.take_all_back();
  }
};

}  // namespace kinescope
