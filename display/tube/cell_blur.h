// What a spot has of width beyond the taps of a curved raster's loops: its cells are blurred by it
// beforehand. The weights are the Fourier series of a Gaussian's spectrum, so that of what cells
// can show blur and taps together pass what the whole spot does.
#pragma once

#include <array>
#include <vector>

#include "display/tube/light_planes.h"
#include "raster/base/workers.h"

namespace kinescope {

class CellBlur {
 public:
  /// Of one Gaussian of the spot, cells and lines squared.
  struct Variance {
    double across = 0, down = 0;
  };
  CellBlur() = default;
  /// @param narrow, wide of the two Gaussians
  CellBlur(const Variance& narrow, const Variance& wide);

  bool empty() const;
  /// @param to is given as many lines beyond the raster's as light reaches
  void blur(const LayerLight& from, int cells, int lines, LayerLight& to, Workers& workers) const;

 private:
  /// Weights of a cell and of those so far to either side.
  using Weights = std::vector<float>;
  struct Axes {
    Weights across, down;
  };
  static Weights weights(double variance);
  static void blur(const Axes& axes, const CellPlane& from, int cells, int lines, int beyond,
                   CellPlane& to, Workers& workers);
  int lines_beyond() const;

  std::array<Axes, 2> axes_{};  // narrow, wide
};

}  // namespace kinescope
