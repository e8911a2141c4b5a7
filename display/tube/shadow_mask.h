// The shadow mask: how much of each gun's light every output pixel lets through. Built as a Fourier
// series over the mask's lattice, whose terms fade out before the output's pixels would alias them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "display/tube/settings.h"
#include "raster/base/workers.h"

namespace kinescope {

class ShadowMask {
 public:
  /// Lets everything through.
  ShadowMask() = default;
  ShadowMask(const MaskSettings& mask, const GlassSettings& glass, int width, int height);

  /// Transmission in units of 1/one(), its mean being 1, from pixel (x, y) on; null if all is let
  /// through.
  float one() const { return planes_[0].empty() ? 1.0f : kOne; }
  const std::uint8_t* row(int gun, int y, int x) const {
    const auto& plane = planes_[static_cast<std::size_t>(gun)];
    return plane.empty() ? nullptr
                         : plane.data() + stored_[static_cast<std::size_t>(y)] * pitch_ + x;
  }

 private:
  void find_stored_rows(std::span<const double> light_of_row, bool alike);
  /// A stored row of up to 8 pixels, darkened by `light`.
  void store(const std::array<std::array<float, 8>, 3>& transmission, double light, int left, int y,
             int count);

  static constexpr int kOne = 48;
  std::array<std::vector<std::uint8_t>, 3> planes_;
  std::vector<int> stored_;  // of each row of pixels, which of the planes' is its own
  std::ptrdiff_t pitch_ = 0;
};

/// A mask's lattice in millimetres on the glass: openings at (i period_x, j period_y), and if
/// centred at half periods too; and the amplitudes of its Fourier series.
class MaskLattice {
 public:
  explicit MaskLattice(const MaskSettings& mask);
  double period_x() const { return period_x_; }
  double period_y() const { return period_y_; }
  /// Amplitude of exp(2 pi i (k x / period_x + l y / period_y)), the mean being 1, for an opening
  /// whose middle is at 0.
  double amplitude(int k, int l) const;
  /// How far to the right a gun's openings lie, mm.
  double offset_mm(int gun) const;
  /// The greatest l that matters; 0 for stripes.
  bool striped() const { return kind_ == MaskKind::kGrille; }

 private:
  MaskKind kind_;
  double period_x_ = 1, period_y_ = 1;
  double open_x_mm_ = 0, open_y_mm_ = 0;  // width and height of an opening; dots: diameter
};

}  // namespace kinescope
