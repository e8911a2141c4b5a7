// The beam's spot as a separable filter from cells to output pixels.
#pragma once

#include <vector>

namespace kinescope {

/// Output pixel p is the sum over t of weight[p * taps + t] times the cell start[p] + t.
struct AxisWeights {
  int taps = 0;
  std::vector<int> start;
  std::vector<float> weight;
};

/// Weights along one axis: a Gaussian spot of the given standard deviation (in cells), integrated
/// over the output pixel. Each cell's light is kept: over all output pixels it sums to 1 (what
/// falls beyond the picture's edge is put back on the pixels inside).
/// @param swept whether the beam sweeps evenly along the cell (across), or stays on its centre
/// (down).
///   Stripes of unswept lines fade out where the pixels are too coarse to show them: there pixels
///   and lines would beat.
AxisWeights spot_weights(int cells, int pixels, double sigma, bool swept);

}  // namespace kinescope
