#include "display/tube/spot.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

// Widths of the two Gaussians, as currents whose spots they are: chosen so that the largest
// difference from the true spot is smallest (tests/display/spot_test.cpp measures it).
constexpr double kNarrowCurrent = 0.1;
constexpr double kWideCurrent = 1;

}  // namespace

SpotModel::SpotModel(const SpotSettings& settings) : settings_(settings) {
  sigma_mm_ = {sigma_mm(kNarrowCurrent), sigma_mm(kWideCurrent)};
}

double SpotModel::sigma_mm(double current) const {
  const double growth = std::cbrt(std::max(current, 0.0));
  return settings_.sigma_mm * settings_.focus * (settings_.least + (1 - settings_.least) * growth);
}

/// The two together have the true spot's height in its middle, where errors would show most.
double SpotModel::wide_part(double current) const {
  const double narrow = sigma_mm_[0], wide = sigma_mm_[1];
  if (!(wide > narrow * (1 + 1e-9))) return 0;
  const double sigma = std::clamp(sigma_mm(current), narrow, wide);
  const auto height = [](double s) { return 1 / (s * s); };
  const double share = (height(narrow) - height(sigma)) / (height(narrow) - height(wide));
  return current * share;
}

double spot_at_voltage(const SpotSettings& settings, double voltage) {
  return std::pow(voltage, -settings.sag_power);
}

}  // namespace kinescope
