// The colours of a block's pixels from those of their fragments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/colour/colour.h"
#include "raster/visible_fragments.h"

namespace kinescope {

/// Where in its block a pixel lies, row by row. Blocks are aligned to the target.
inline std::size_t pixel_in_block(std::uint32_t xy) {
  constexpr std::uint32_t kSide = TileBuffer::kBlock;
  return (xy >> 16) % kSide * kSide + xy % kSide;
}

/// The mean of each pixel's samples: its fragments in their order, then the clear colour where none
/// is.
/// @param first,end  the block's fragments
void average_samples(const VisibleFragments& fragments, std::span<const LinearRgba> colours,
                     std::size_t first, std::size_t end, int samples, const LinearRgba& clear,
                     std::array<LinearRgba, TileBuffer::kBlockPixels>& out);

}  // namespace kinescope
