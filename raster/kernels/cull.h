// The front end's first step, SIMD across triangles: snap, cull, and sort by size.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "raster/draw_call.h"
#include "raster/sample_pattern.h"
#include "raster/tile_grid.h"

namespace kinescope {

/// Consecutive triangles of one draw call: what one task of the front end takes.
struct TriangleRange {
  static constexpr int kMaxCount = 1024;
  std::uint32_t call, first, count;
};

/// Triangles that survived, up to one range of them.
struct CulledTriangles {
  static constexpr std::size_t kCapacity = TriangleRange::kMaxCount + 16;
  /// A box this large, in pixels either way, is the largest that counts as small.
  static constexpr int kSmallPx = 16;

  /// Small triangles within the target: raw Fixed24_8, turned to positive area; depths in [0, 1].
  int small_size = 0;
  alignas(64) std::array<std::array<std::int32_t, kCapacity>, 3> x, y;
  alignas(64) std::array<std::array<float, kCapacity>, 3> z;
  alignas(64) std::array<std::uint32_t, kCapacity> small_triangle;  ///< index in the call

  /// The others: index in the call. Those of more than 64 pixels are not culled by facing yet.
  int large_size = 0;
  alignas(64) std::array<std::uint32_t, kCapacity> large_triangle;
};

/// What does not change from triangle to triangle: used by the kernel.
struct CullLimits {
  std::int32_t least_x, most_x, least_y, most_y;  ///< sample offsets, raw
  std::int32_t width, height;                     ///< of the target, pixels
  CullMode mode;
};

void cull_triangles(const DrawCall& call, std::uint32_t first, std::uint32_t count,
                    std::span<const SampleOffset> pattern, const TileGrid& grid,
                    CulledTriangles& out);

}  // namespace kinescope
