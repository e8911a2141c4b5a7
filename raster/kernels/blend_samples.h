// Colours of fragments onto the colours of a tile's samples.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/aligned_vector.h"
#include "raster/blending.h"
#include "raster/colour/colour.h"
#include "raster/ordered/ordered_fragments.h"
#include "raster/tile.h"

namespace kinescope {

/// The colours of a tile's samples, as TileBuffer orders them.
struct TileColours {
  AlignedVector<LinearRgba> samples;
  std::vector<std::uint8_t> touched;  ///< of each pixel: whether anything was blended onto it
};

/// Blends fragments [first, first + colours.size()) in their order, all in one mode.
void blend_in_order(BlendMode mode, const OrderedFragments& fragments, int first,
                    std::span<const LinearRgba> colours, const TileBuffer& tile, TileColours& to);

/// Storage of blend_by_depth.
struct DepthOrder {
  std::vector<std::uint32_t> first;     ///< of each pixel, and one more
  std::vector<std::uint32_t> fragment;  ///< pixel by pixel
  std::vector<std::uint64_t> keys;      ///< of one pixel
};

/// Blends fragments far to near at each sample, equal depths in their order.
/// @param modes  one a fragment
/// @param band  holds their pixels: rows of the tile
void blend_by_depth(std::span<const BlendMode> modes, const OrderedFragments& fragments,
                    std::span<const LinearRgba> colours, const PixelRect& band,
                    const TileBuffer& tile, DepthOrder& order, TileColours& to);

}  // namespace kinescope
