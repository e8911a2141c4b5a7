// Attributes of whole blocks that a few triangles share: no fragment needs to say whose it is.
#pragma once

#include <array>
#include <cstdint>

#include "raster/kernels/batch_storage.h"
#include "raster/kernels/block_owners.h"

namespace kinescope {

/// Blocks of one draw call that make a batch, their pixels row by row.
struct BlockBatch {
  static constexpr std::size_t kMaxBlocks = Batch::kMaxSize / TileBuffer::kBlockPixels;

  /// Pixels of a block that one triangle owns.
  struct Share {
    std::uint64_t pixels;
    std::size_t triangle;  ///< where in WeightPlanes
  };
  struct Block {
    int x0, y0;       ///< its first pixel in the target
    std::size_t end;  ///< of its shares, which follow those of the block before
  };

  std::size_t size = 0;
  std::size_t triangles = 0;  ///< named by the planes
  std::size_t ready = 0;      ///< of those: set up for an earlier batch of the call
  std::array<Block, kMaxBlocks> block;
  std::array<Share, kMaxBlocks * BlockOwners::kMax> share;
};

/// Fills x, y, triangle, facing, attribute and gradient, by the law of interpolate(), bit by bit.
/// Planes are set up where they are not ready.
void interpolate_blocks(const DrawCall& call, const BlockBatch& blocks, BatchStorage& batch);

}  // namespace kinescope
