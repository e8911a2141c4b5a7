// The matrices of ordered dithering: an order in which the cells of a tile light up.
#pragma once

#include <cstdint>
#include <vector>

namespace kinescope {

struct ThresholdMatrix {
  int side = 1;
  std::vector<std::uint16_t> ranks{0};  ///< 0 to side^2 - 1, each once, row by row; 0 lights first

  int rank(int x, int y) const {
    return ranks[static_cast<std::size_t>(y % side * side + x % side)];
  }
};

/// Dispersed dots. Source: B. E. Bayer, "An optimum method for two-level rendition of
/// continuous-tone pictures", 1973.
/// @param side 1, 2, 4, ... 64. @throws Error (usage) for another
ThresholdMatrix bayer_matrix(int side);

/// One dot a tile that grows from the middle: halftoning. Cells light in order of their distance
/// from it, of equals by their angle.
/// Source: R. Ulichney, "Digital Halftoning", 1987.
/// @param side 2 to 8. @throws Error (usage) for another
ThresholdMatrix clustered_dot_matrix(int side);

}  // namespace kinescope
