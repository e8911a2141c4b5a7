// How the screen is cut into tiles.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/pixel_rect.h"

namespace kinescope {

struct TileGrid {
  int width = 0, height = 0;              ///< of the target
  int tile_width = 64, tile_height = 64;  ///< multiples of 8, at most kMaxTile
  int columns = 0, rows = 0;
  std::uint64_t per_column = 0, per_row = 0;  ///< 2^24 / side, rounded up

  /// Within a tile of this size an edge that crosses it fits 32 bits (kernels/tile_edges-inl.h).
  static constexpr int kMaxTile = 64;

  TileGrid() = default;
  TileGrid(int w, int h, int tile_w, int tile_h)
      : width(w),
        height(h),
        tile_width(tile_w),
        tile_height(tile_h),
        columns((w + tile_w - 1) / tile_w),
        rows((h + tile_h - 1) / tile_h),
        per_column(((1u << 24) + static_cast<unsigned>(tile_w) - 1) /
                   static_cast<unsigned>(tile_w)),
        per_row(((1u << 24) + static_cast<unsigned>(tile_h) - 1) / static_cast<unsigned>(tile_h)) {}

  /// Division by multiplication: exact below 2^18 pixels.
  int column_of(int x) const {
    return static_cast<int>((static_cast<unsigned>(x) * per_column) >> 24);
  }
  int row_of(int y) const { return static_cast<int>((static_cast<unsigned>(y) * per_row) >> 24); }
  int count() const { return columns * rows; }
  PixelRect rect(int tile) const {
    const int x = tile % columns * tile_width;
    const int y = tile / columns * tile_height;
    return {x, y, std::min(x + tile_width, width), std::min(y + tile_height, height)};
  }
};

}  // namespace kinescope
