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
  /// Boxes of less than this many pixels, both ways, are small; then medium, and the longer ones of
  /// triangles so thin that hardly a block of 8x8 pixels lies within.
  static constexpr int kSmallPx = 8, kMediumPx = 32, kMostMediumPx = 64, kThinPx = 28;
  static constexpr std::size_t kCapacity = TriangleRange::kMaxCount + 16;
  /// Turned to positive area; raw Fixed24_8, depths in [0, 1], index in the call.
  struct Snapped {
    int size = 0;
    alignas(64) std::array<std::array<std::int32_t, kCapacity>, 3> x, y;
    alignas(64) std::array<std::array<float, kCapacity>, 3> z;
    alignas(64) std::array<std::uint32_t, kCapacity> triangle;
  };
  Snapped small;  ///< these touch no pixel outside the target

  /// Small triangles that cover one pixel, finished; only at one sample a pixel, where asked for.
  struct Pixels {
    int size = 0;
    alignas(64) std::array<std::uint32_t, kCapacity> xy;  ///< y << 16 | x
    alignas(64) std::array<float, kCapacity> z;
    alignas(64) std::array<std::uint32_t, kCapacity> triangle;
  };
  Pixels pixels;
  Snapped medium;

  /// The others: index in the call. Those of kMostMediumPx and more are not culled by facing yet.
  int large_size = 0;
  alignas(64) std::array<std::uint32_t, kCapacity> large_triangle;
};

/// What does not change from triangle to triangle: used by the kernel.
struct CullLimits {
  std::span<const SampleOffset> pattern;
  SampleLimits samples;
  std::int32_t width, height;  ///< of the target, pixels
  CullMode mode;
  bool finish_pixels;
};

/// @param finish_pixels  whether triangles that cover one pixel may go to `pixels`
void cull_triangles(const DrawCall& call, std::uint32_t first, std::uint32_t count,
                    std::span<const SampleOffset> pattern, const TileGrid& grid, bool finish_pixels,
                    CulledTriangles& out);

}  // namespace kinescope
