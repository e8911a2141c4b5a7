// The weights with which cells along one axis (pixels of a line, or lines) add up to an output
// pixel, where the raster's two axes lie apart: the spot's profile, exactly, over the pixel's
// width.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "raster/aligned_vector.h"

namespace kinescope {

struct AxisWeights {
  int taps = 0;
  std::vector<int>
      start;  ///< of each pixel: its first cell; may lie before 0 or reach past the last
  /// Of the narrow and of the wide Gaussian, tap after tap: weight[b][tap * pitch + pixel].
  std::array<AlignedVector<float>, 2> weight;
  int pitch = 0;  ///< pixels, rounded up to whole cache lines
  float at(std::size_t basis, int pixel, int tap) const {
    return weight[basis][static_cast<std::size_t>(tap * pitch + pixel)];
  }
};

/// @param edges of the pixels, one more than there are, in cells; increasing
/// @param sigma_pixels of the narrow and the wide Gaussian, output pixels
/// @param cells_a_pixel the mean, of which the light of white is 1
/// @param swept whether the beam moves along this axis while it is on a cell (or stands on a line)
AxisWeights axis_weights(std::span<const double> edges, std::array<double, 2> sigma_pixels,
                         double cells_a_pixel, bool swept);

/// By how much the spot, in lines, must be wider so that lines closer than about two output rows
/// make no beat with them: the variance to add. @param pitch lines a row
double line_blur_variance(double pitch);

}  // namespace kinescope
