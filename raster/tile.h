// The samples of the tile being drawn: depth, and which triangle is visible.
#pragma once

#include <array>
#include <cstdint>

#include "raster/aligned_vector.h"
#include "raster/bins.h"

namespace kinescope {

/// Rows of tile_width pixels, the samples of a pixel side by side; what lies beyond the target's
/// edge is not looked at.
///
/// The tile is cut into blocks of 8x8 pixels. One that a single triangle covers, or none, is known
/// by that triangle alone: its samples are written only when another triangle shares the block.
struct TileBuffer {
  static constexpr std::uint32_t kNothing = 0xffffffffu;
  static constexpr int kBlock = 8;  ///< pixels of a block's side
  static constexpr int kBlockPixels = kBlock * kBlock;
  static constexpr int kMaxBlocks = (TileGrid::kMaxTile / kBlock) * (TileGrid::kMaxTile / kBlock);

  PixelRect rect;  ///< of the target's pixels
  int stride = 0;  ///< pixels of a row
  int pixels = 0;  ///< of the whole tile
  int samples = 1;
  float farthest = 1;               ///< no sample shows anything beyond this depth
  AlignedVector<float> depth;       ///< 1 where nothing is visible
  AlignedVector<std::uint32_t> id;  ///< kNothing there

  int block_columns = 0, block_rows = 0;
  std::uint64_t stored = 0;  ///< a bit a block, row by row: its samples are in `depth` and `id`
  /// Of each other block: what all its samples show, null for nothing.
  std::array<const TriangleRecord*, kMaxBlocks> shown{};
  std::uint64_t stale = 0;  ///< a bit a block: samples were written since its farthest was found
  /// Bounds on the depth of what each block shows; of those not stored, exact at the corners.
  std::array<float, kMaxBlocks> block_nearest{};
  alignas(64) std::array<float, kMaxBlocks> block_farthest{};
  /// How many medium triangles were drawn into a block since its farthest was found.
  std::array<std::uint8_t, kMaxBlocks> drawn{};

  /// Empties the buffer for a tile.
  void begin(const TileGrid& grid, int tile, int sample_count);

  bool is_stored(int block) const { return (stored >> block & 1) != 0; }
  /// The block's pixels, within the target.
  PixelRect block_rect(int block) const;
};

}  // namespace kinescope
