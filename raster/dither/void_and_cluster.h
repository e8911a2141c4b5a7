// A blue-noise matrix: each dot goes where there are fewest.
// Source: R. Ulichney, "The void-and-cluster method for dither array generation", 1993.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/dither/threshold_matrix.h"

namespace kinescope {

/// Ranks the cells of a tile that repeats, one a step: first those of a starting pattern backwards,
/// taking away what lies in the tightest cluster, then the rest, filling the largest void.
class VoidAndCluster {
 public:
  /// @param side 4 to 128. @throws Error (usage) for another
  VoidAndCluster(int side, std::uint64_t seed);

  /// Ranks one more cell; false when all are ranked.
  bool next();
  int cell() const { return cell_; }  ///< the one just ranked: y side + x
  int rank() const { return rank_; }
  bool is_dot(int cell) const { return dots_[static_cast<std::size_t>(cell)] != 0; }
  /// How crowded a cell is: the Gaussian-weighted number of dots around it.
  double crowding(int cell) const { return crowding_[static_cast<std::size_t>(cell)]; }
  const ThresholdMatrix& matrix() const { return matrix_; }  ///< whole after the last step

 private:
  void set(int cell, bool dot);
  int tightest_cluster() const;
  int largest_void() const;
  void begin(std::uint64_t seed);

  int side_, start_ = 0, removed_ = 0, cell_ = 0, rank_ = -1;
  std::vector<std::uint8_t> dots_, first_pattern_;
  std::vector<double> crowding_, weights_;
  ThresholdMatrix matrix_;
};

ThresholdMatrix blue_noise_matrix(int side, std::uint64_t seed);

}  // namespace kinescope
