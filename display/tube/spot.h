// The beam's spot. Its width depends on the current, so no single filter draws it; but current
// times a Gaussian is close to a sum of two Gaussians of fixed widths, in shares that depend on the
// current alone and add up to it. Spreading is then linear.
#pragma once

#include <array>

#include "display/tube/settings.h"

namespace kinescope {

class SpotModel {
 public:
  explicit SpotModel(const SpotSettings& settings);

  /// Standard deviation of the spot down the screen at a current, white's being 1, mm.
  double sigma_mm(double current) const;
  /// The narrow and the wide Gaussian, down the screen, mm.
  double narrow_mm() const { return sigma_mm_[0]; }
  double wide_mm() const { return sigma_mm_[1]; }
  /// Widths across are this many times those down.
  double astigmatism() const { return settings_.astigmatism; }
  /// The part of a current that the wide Gaussian draws; the narrow one draws the rest.
  double wide_part(double current) const;

 private:
  SpotSettings settings_;
  std::array<double, 2> sigma_mm_{};
};

/// How many times wider the spot is at a share of the high voltage, whatever its current: both
/// Gaussians widen alike.
double spot_at_voltage(const SpotSettings& settings, double voltage);

}  // namespace kinescope
