// Halation: light that spreads within the glass before it leaves, as a wide, weak glow. Found on a
// coarse grid, from the cells.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "display/tube/finish_kernels.h"
#include "display/tube/light_planes.h"
#include "display/tube/settings.h"
#include "raster/base/workers.h"

namespace kinescope {

class Halation {
 public:
  Halation() = default;
  Halation(const TubeSettings& settings, int width, int height);

  /// The share of light that goes astray.
  float share() const { return share_; }
  /// Finds the glow, over what light is left, times `unit`.
  /// @param light of each layer's cells, or empty
  /// @param overlay light of each layer's output pixels besides, or null
  void gather(std::span<const LayerLight> light, const std::vector<std::vector<float>>* overlay,
              float unit, Workers& workers);
  /// The glow at pixel (x, y) and on: two coarse rows, null if there is none.
  /// @return how much of the lower one
  float rows(std::size_t layer, int y, int x, const float*& above, const float*& below) const;

 private:
  /// Where a coarse pixel lies among blocks of cells: the one above and left of it, and how far
  /// from there.
  struct Sample {
    int at = 0;
    float right = 0, down = 0;
  };
  using Plane = std::vector<float>;

  void pool(const LayerLight& light, int row, Plane& sums, Plane& blocks) const;
  void look_up(const Plane& blocks, Plane& coarse) const;
  void add_means(const Plane& pixels, Plane& coarse) const;
  void blur(const Plane& coarse, int row, Plane& down, Plane& out) const;
  void widen(const Plane& coarse_row, float glow, float* out) const;
  std::ptrdiff_t fine_pitch() const { return width_ + 16; }

  float share_ = 0;
  int step_ = 8;  // output pixels a coarse one
  int width_ = 0, height_ = 0, cells_ = 0, lines_ = 0, coarse_width_ = 0, coarse_height_ = 0;
  int block_cells_ = 1, block_lines_ = 1;    // in a block
  int blocks_across_ = 0, blocks_down_ = 0;  // with a dark one on each side
  std::vector<Sample> samples_;
  std::vector<float> kernel_;  // from its middle on
  std::array<Plane, kMostLayers> blocks_, coarse_, fine_;
  std::vector<Plane> sums_, downs_;  // of each worker
};

}  // namespace kinescope
