#include "raster/dither/void_and_cluster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr double kSigma = 1.5;  // cells; Ulichney's choice

}  // namespace

VoidAndCluster::VoidAndCluster(int side, std::uint64_t seed) : side_(side) {
  if (side < 4 || side > 128) {
    throw Error(ErrorKind::kUsage,
                fmt::format("a blue-noise matrix has a side of 4 to 128, not {}", side));
  }
  const auto cells = static_cast<std::size_t>(side * side);
  dots_.resize(cells);
  crowding_.resize(cells);
  weights_.resize(cells);
  matrix_ = {side, std::vector<std::uint16_t>(cells)};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int dx = std::min(x, side - x), dy = std::min(y, side - y);
      weights_[static_cast<std::size_t>(y * side + x)] =
          std::exp(-(dx * dx + dy * dy) / (2 * kSigma * kSigma));
    }
  }
  begin(seed);
}

void VoidAndCluster::set(int cell, bool dot) {
  dots_[static_cast<std::size_t>(cell)] = dot;
  const int cx = cell % side_, cy = cell / side_;
  const double sign = dot ? 1 : -1;
  for (int y = 0; y < side_; ++y) {
    const double* row = weights_.data() + (y - cy + side_) % side_ * side_;
    double* to = crowding_.data() + y * side_;
    for (int x = 0; x < cx; ++x) to[x] += sign * row[x - cx + side_];
    for (int x = cx; x < side_; ++x) to[x] += sign * row[x - cx];
  }
}

int VoidAndCluster::tightest_cluster() const {
  int best = -1;
  for (int i = 0; i < side_ * side_; ++i) {
    if (is_dot(i) && (best < 0 || crowding(i) > crowding(best))) best = i;
  }
  return best;
}

int VoidAndCluster::largest_void() const {
  int best = -1;
  for (int i = 0; i < side_ * side_; ++i) {
    if (!is_dot(i) && (best < 0 || crowding(i) < crowding(best))) best = i;
  }
  return best;
}

// A tenth of the cells at random; then dots move from clusters to voids until one would come back.
void VoidAndCluster::begin(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto cells = static_cast<std::uint64_t>(side_ * side_);
  start_ = std::max(1, side_ * side_ / 10);
  for (int i = 0; i < start_;) {
    const int cell = static_cast<int>(random() % cells);
    if (is_dot(cell)) continue;
    set(cell, true);
    ++i;
  }
  for (int i = 0; i < side_ * side_; ++i) {  // far more than it takes
    const int from = tightest_cluster();
    set(from, false);
    const int to = largest_void();
    set(to, true);
    if (to == from) break;
  }
  first_pattern_ = dots_;
}

bool VoidAndCluster::next() {
  if (removed_ < start_) {
    cell_ = tightest_cluster();
    set(cell_, false);
    rank_ = start_ - 1 - removed_;
    ++removed_;
    if (removed_ == start_) {
      for (int i = 0; i < side_ * side_; ++i) {
        if (first_pattern_[static_cast<std::size_t>(i)]) set(i, true);
      }
    }
  } else {
    const int filled = rank_ < start_ ? start_ : rank_ + 1;
    if (filled == side_ * side_) return false;
    cell_ = largest_void();
    set(cell_, true);
    rank_ = filled;
  }
  matrix_.ranks[static_cast<std::size_t>(cell_)] = static_cast<std::uint16_t>(rank_);
  return true;
}

ThresholdMatrix blue_noise_matrix(int side, std::uint64_t seed) {
  VoidAndCluster ranking(side, seed);
  while (ranking.next()) {
  }
  return ranking.matrix();
}

}  // namespace kinescope
