// Whole blocks that few triangles share go through their shader together, and straight to the
// target.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fragment_batches.h"
#include "raster/kernels/interpolate_blocks.h"
#include "raster/render_target.h"
#include "raster/tile.h"

namespace kinescope {

/// One worker's storage for batches of blocks.
class BlockShader {
 public:
  /// Shades what it can of a tile's blocks.
  /// @return a bit for each block that is left
  std::uint64_t shade(const FrameCalls& frame, const TileBuffer& tile, RenderTarget& target);

 private:
  bool is_of_call(const FrameCalls& frame, const BlockOwners& owners) const;
  std::size_t place_of(std::uint32_t triangle);
  void add(const FrameCalls& frame, const PixelRect& rect, const BlockOwners& owners);
  void shade_batch(const FrameCalls& frame, RenderTarget& target);

  int call_ = 0;  ///< of the batch
  BlockBatch blocks_;
  BlockOwners owners_;
  /// Where in the planes triangles were put, by their last eight bits.
  std::array<std::uint16_t, 256> place_{};
  BatchStorage storage_;
  alignas(64) std::array<LinearRgba, Batch::kMaxSize> colours_{};
};

}  // namespace kinescope
