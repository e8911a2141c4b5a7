// The light of every cell in an exposure, a plane for each phosphor layer and Gaussian of the spot.
#pragma once

#include <cstddef>

#include "display/tube/spread_kernels.h"
#include "raster/aligned_vector.h"

namespace kinescope {

/// One plane of cells, with dark ones around each line.
class CellPlane {
 public:
  CellPlane() = default;
  CellPlane(int cells, int lines)
      : pitch_(whole_cache_lines<float>(cells + 2 * kCellPad)),
        light_(static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(lines), 0.0f) {}
  /// Cell 0 of a line.
  float* line(int number) { return light_.data() + offset(number); }
  const float* line(int number) const { return light_.data() + offset(number); }
  int pitch() const { return static_cast<int>(pitch_); }

 private:
  std::ptrdiff_t offset(int number) const {
    return static_cast<std::ptrdiff_t>(number) * pitch_ + kCellPad;
  }
  std::ptrdiff_t pitch_ = 0;
  AlignedVector<float> light_;
};

/// By layer, as the narrow and as the wide Gaussian draws it.
struct LayerLight {
  CellPlane narrow, wide;
  int beyond = 0;  ///< lines that the planes have before the raster's first and after its last

  CellRows rows(int line) const {
    return {narrow.line(line + beyond), wide.line(line + beyond), narrow.pitch()};
  }
};

}  // namespace kinescope
