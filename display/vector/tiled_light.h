// Planes of floats over a picture, stored tile by tile, so that one worker draws one tile.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "display/vector/stroke_kernel.h"
#include "raster/aligned_vector.h"

namespace kinescope {

/// Tiles that nothing was drawn on are not lit, and hold zeros.
class TiledLight {
 public:
  TiledLight() = default;
  TiledLight(int width, int height, int planes)
      : width_(width),
        height_(height),
        planes_(planes),
        columns_((width + kBeamTile - 1) / kBeamTile),
        rows_((height + kBeamTile - 1) / kBeamTile),
        lit_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0),
        light_(lit_.size() * tile_floats(), 0.0f) {}

  int width() const { return width_; }
  int height() const { return height_; }
  int planes() const { return planes_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int tiles() const { return static_cast<int>(lit_.size()); }
  bool lit(int tile) const { return lit_[static_cast<std::size_t>(tile)] != 0; }
  void set_lit(int tile, bool lit) { lit_[static_cast<std::size_t>(tile)] = lit; }

  BeamTile tile(int number) {
    return {number % columns_ * kBeamTile, number / columns_ * kBeamTile, planes_,
            plane(number, 0)};
  }
  /// One plane of a tile: row y begins at y * kBeamTile.
  float* plane(int tile, int plane) { return light_.data() + offset(tile, plane); }
  const float* plane(int tile, int plane) const { return light_.data() + offset(tile, plane); }
  /// For tests; slow.
  float at(int plane_number, int x, int y) const {
    const int tile = y / kBeamTile * columns_ + x / kBeamTile;
    return plane(tile, plane_number)[y % kBeamTile * kBeamTile + x % kBeamTile];
  }
  void clear() {
    std::fill(lit_.begin(), lit_.end(), std::uint8_t{0});
    std::fill(light_.begin(), light_.end(), 0.0f);
  }

 private:
  std::size_t tile_floats() const {
    return static_cast<std::size_t>(planes_) * static_cast<std::size_t>(kBeamTilePlane);
  }
  std::size_t offset(int tile, int plane) const {
    return static_cast<std::size_t>(tile) * tile_floats() +
           static_cast<std::size_t>(plane) * static_cast<std::size_t>(kBeamTilePlane);
  }

  int width_ = 0, height_ = 0, planes_ = 0, columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> lit_;
  AlignedVector<float> light_;
};

}  // namespace kinescope
