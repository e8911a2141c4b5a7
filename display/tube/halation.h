// Halation: light that spreads within the glass before it leaves, as a wide, weak glow. Found on a
// coarse grid, from the cells.
#pragma once

#include <array>
#include <span>
#include <vector>

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
  void gather(std::span<const LayerLight> light, Workers& workers);
  /// The glow, over what light is left, at pixel (x, y) and on: two coarse rows, and how much of
  /// the lower one. Null if there is none.
  void rows(std::size_t layer, int y, int x, const float*& above, const float*& below,
            float& below_share) const;

 private:
  struct Range {
    int begin = 0, end = 0;
  };
  struct Patch {  // of cells that a coarse pixel shows
    Range cells, lines;
  };
  void pool(const LayerLight& light, int row, float* out) const;
  void blur(std::vector<float>& coarse) const;
  void widen(const std::vector<float>& coarse, int row, float* out) const;
  std::ptrdiff_t fine_pitch() const { return width_ + 16; }

  float share_ = 0;
  int step_ = 8;  // output pixels a coarse one
  int width_ = 0, coarse_width_ = 0, coarse_height_ = 0;
  std::vector<Patch> patches_;
  std::vector<float> kernel_;  // from its middle on
  std::array<std::vector<float>, 3> coarse_, fine_;
};

}  // namespace kinescope
