// Small triangles in one tile, SIMD across them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "raster/bins.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// Fragments of pixels of a tile, one a pixel and triangle, on their way to the depth test.
struct FragmentBuffer {
  /// More of them are tested at once, while they are in a first-level cache.
  static constexpr std::size_t kEnough = 192;
  /// Those and a group of triangles. Not a power of two, lest arrays compete for the same lines.
  static constexpr std::size_t kCapacity = 1024 + 16;
  alignas(64) std::array<std::uint32_t, kCapacity> pixel;  ///< row * tile_width + column
  alignas(64) std::array<std::uint32_t, kCapacity> id;
  /// Of each sample; if there are several, infinite where the triangle does not cover one.
  alignas(64) std::array<std::array<float, kCapacity>, 8> depth;
  std::size_t size = 0;
};

/// Visibility of the triangles' samples in the tile.
/// @param across  whether they may touch other tiles too
/// @param buffer  a worker's storage, empty before and after
void draw_small_triangles(const ChunkList<TriangleChunk>& triangles, bool across,
                          std::span<const SampleOffset> pattern, TileBuffer& tile,
                          FragmentBuffer& buffer);

}  // namespace kinescope
