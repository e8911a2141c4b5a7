// Error diffusion: what a pixel's level takes too much or too little is carried to its neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "raster/dither/diffusion_kernel.h"
#include "raster/dither/grey.h"

namespace kinescope {

/// One pixel a step. Errors are whole numbers of 1/256 code; what the shares' rounding leaves goes
/// with the last, so that (but for Atkinson's) no light is lost except beyond the picture's edge.
template <const DiffusionKernel& kKernel = kFloydSteinberg>
class ErrorDiffusion {
 public:
  /// @param levels evenly spaced from 0 to 255, 2 to 256
  /// @param serpentine every other row from right to left, which breaks up worms
  explicit ErrorDiffusion(const GreyImage& image, int levels = 2, bool serpentine = true)
      : image_(image), levels_(std::clamp(levels, 2, 256)), serpentine_(serpentine), at_(-2, 0) {
    for (auto& row : errors_) row.resize(static_cast<std::size_t>(image.width()) + 2 * kReach);
    for (int i = 0; i < levels_; ++i) {
      codes_[static_cast<std::size_t>(i)] = i * 255 * kOne / (levels_ - 1);
    }
  }

  bool next() {
    at_.x += direction_;
    if (at_.x < 0 || at_.x >= image_.width()) {
      if (!begin_row()) return false;
    }
    value_ = image_.at(at_.x, at_.y) * kOne + error_at(0, 0);
    constexpr int kWhite = 255 * kOne;
    level_ = (2 * std::clamp(value_, 0, kWhite) * (levels_ - 1) + kWhite) / (2 * kWhite);
    error_ = value_ - codes_[static_cast<std::size_t>(level_)];
    carry(std::make_index_sequence<kKernel.count - 1>());
    return true;
  }

  glm::ivec2 at() const { return at_; }
  int direction() const { return direction_; }
  int level() const { return level_; }
  double value() const { return value_ / double{kOne}; }  ///< with the errors carried to it, codes
  double error() const { return error_ / double{kOne}; }  ///< of its level
  /// What has been carried so far to a pixel of this row or the two below.
  double carried(int x, int dy) const {
    return errors_[static_cast<std::size_t>((at_.y + dy) % kRows)]
                  [static_cast<std::size_t>(x + kReach)] /
           double{kOne};
  }

 private:
  static constexpr int kOne = 256, kReach = 2, kRows = 3;

  int& error_at(int dx, int dy) {
    return errors_[static_cast<std::size_t>(rows_[static_cast<std::size_t>(dy)])]
                  [static_cast<std::size_t>(at_.x + dx * direction_ + kReach)];
  }

  bool begin_row() {
    if (begun_) {
      std::fill(errors_[static_cast<std::size_t>(rows_[0])].begin(),
                errors_[static_cast<std::size_t>(rows_[0])].end(), 0);
      ++at_.y;
    }
    begun_ = true;
    if (at_.y >= image_.height() || image_.width() == 0) return false;
    for (int dy = 0; dy < kRows; ++dy) rows_[static_cast<std::size_t>(dy)] = (at_.y + dy) % kRows;
    direction_ = serpentine_ && at_.y % 2 ? -1 : 1;
    at_.x = direction_ > 0 ? 0 : image_.width() - 1;
    return true;
  }

  template <std::size_t... kTaps>
  void carry(std::index_sequence<kTaps...>) {
    int rest = 0, whole = 0;
    const auto give = [&](const DiffusionKernel::Tap& tap) {
      const int share = error_ * tap.weight / kKernel.divisor;
      rest += share;
      whole += tap.weight;
      error_at(tap.dx, tap.dy) += share;
    };
    (give(kKernel.taps[kTaps]), ...);
    constexpr DiffusionKernel::Tap kLast = kKernel.taps[kKernel.count - 1];
    const int all = error_ * (whole + kLast.weight) / kKernel.divisor;
    error_at(kLast.dx, kLast.dy) += all - rest;
  }

  const GreyImage& image_;
  int levels_;
  bool serpentine_, begun_ = false;
  std::array<std::vector<int>, kRows> errors_;
  std::array<int, kRows> rows_{0, 1, 2};
  std::array<int, 256> codes_{};
  glm::ivec2 at_;
  int direction_ = 1, value_ = 0, error_ = 0, level_ = 0;
};

/// Calls sink(x, y, level) for each pixel, in the order of the scan.
template <const DiffusionKernel& kKernel, typename Sink>
void diffuse_errors(const GreyImage& image, int levels, bool serpentine, Sink&& sink) {
  ErrorDiffusion<kKernel> diffusion(image, levels, serpentine);
  while (diffusion.next()) sink(diffusion.at().x, diffusion.at().y, diffusion.level());
}

}  // namespace kinescope
