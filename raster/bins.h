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

/// Triangles of middle size as structure of arrays, as CulledTriangles holds them.
struct MediumChunk {
  static constexpr std::size_t kCapacity = 24;
  std::array<std::array<std::int32_t, kCapacity>, 3> x, y;
  std::array<std::array<float, kCapacity>, 3> z;
  std::array<std::uint32_t, kCapacity> id;
  MediumChunk* next;
  int size;
};

struct RecordChunk {
  static constexpr int kCapacity = 15;
  std::array<TriangleRecord, kCapacity> records;
  RecordChunk* next;
  int size;
};

/// Fragments, one a pixel and triangle, as structure of arrays, so that SIMD can append them
/// compressed.
template <int kSamples>
struct FragmentChunkOf {
  static constexpr std::size_t kCapacity = kSamples == 1 ? 168 : 64;
  std::array<std::uint32_t, kCapacity> pixel;  ///< row * tile_width + column, in the tile
  std::array<std::uint32_t, kCapacity> id;
  /// Of each sample; if there are several, infinite where the triangle does not cover one.
  std::array<std::array<float, kCapacity>, kSamples> depth;
  FragmentChunkOf* next;
  int size;
};
using FragmentChunk = FragmentChunkOf<1>;
using SampledChunk = FragmentChunkOf<8>;  ///< of a frame with four samples, the first four arrays

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
    (last == nullptr ? first : last->next) = chunk;
    last = chunk;
  }
};

/// One worker's bins, a list a tile: no worker waits for another. Since the nearest fragment wins,
/// and of equals the one submitted first, the order in which bins are drawn does not matter.
struct Bins {
  std::vector<ChunkList<RecordChunk>> records;
  std::vector<ChunkList<MediumChunk>> medium;
  std::vector<ChunkList<FragmentChunk>> fragments;  ///< of a frame with one sample a pixel
  std::vector<ChunkList<SampledChunk>> sampled;     ///< of a frame with more
  ChunkPool<RecordChunk> record_pool;
  ChunkPool<MediumChunk> medium_pool;
  ChunkPool<FragmentChunk> fragment_pool;
  ChunkPool<SampledChunk> sampled_pool;

  void clear(int tiles) {
    records.assign(static_cast<std::size_t>(tiles), {});
    medium.assign(static_cast<std::size_t>(tiles), {});
    fragments.assign(static_cast<std::size_t>(tiles), {});
    sampled.assign(static_cast<std::size_t>(tiles), {});
    record_pool.take_all_back();
    medium_pool.take_all_back();
    fragment_pool.take_all_back();
    sampled_pool.take_all_back();
  }
};

}  // namespace kinescope
