// Fragments of a tile that are to be shaded: one a pixel and triangle, block by block, row by row.
#pragma once

#include <array>
#include <cstdint>

#include "raster/batch.h"
#include "raster/tile.h"

namespace kinescope {

/// Those of some blocks of a tile, structure of arrays, `size` entries each.
struct VisibleFragments {
  /// Blocks are added until less than a block's pixels would fit a batch; the last may hold a
  /// fragment for each of eight samples. Whole vectors are stored at the end.
  static constexpr int kEnough = Batch::kMaxSize - TileBuffer::kBlockPixels;
  static constexpr int kCapacity = kEnough + 8 * TileBuffer::kBlockPixels + 16;

  int size = 0;
  alignas(64) std::array<std::uint32_t, kCapacity> id;
  /// Pixel in the target: x in the low half, y in the high.
  alignas(64) std::array<std::uint32_t, kCapacity> xy;
  std::array<std::uint8_t, kCapacity> weight;  ///< samples covered in the pixel; unset at one

  int blocks = 0;
  std::array<int, TileBuffer::kMaxBlocks> block{};  ///< of the tile
  /// The first fragment of each block, and one entry more.
  std::array<int, TileBuffer::kMaxBlocks + 1> block_first{};
  /// Whether each of a block's 64 pixels shows one triangle at all of its samples.
  std::array<bool, TileBuffer::kMaxBlocks> block_is_whole{};
};

}  // namespace kinescope
