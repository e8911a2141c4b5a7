#include "display/vector/dose_light.h"

#include <cmath>

#include "display/decay.h"

namespace kinescope {
namespace {

/// After so many time constants what is left, 2e-9 of a dose, is given out at once.
constexpr double kGone = 20;
/// Over so short a dwell the mean of a decay is 1 + q^2 / 24 times that of its middle, to 1e-7.
constexpr double kShortDwell = 0.1;

/// The share of a dose that is still to come when its exposure ends.
double share_left(double dwell, double since_end, double tau) {
  if (since_end > kGone * tau) return 0;
  const double q = dwell / tau;
  if (q > kShortDwell) return left_of_dose(since_end + dwell, dwell, tau);
  return std::exp(-since_end / tau - 0.5 * q) * (1 + q * q * (1.0 / 24));
}

}  // namespace

void add_dose_weights(const std::vector<LightLayer>& layers, double dose,
                      const std::array<float, 3>& guns, Seconds begin, Seconds end, Seconds until,
                      std::vector<float>& weights) {
  const double dwell = (end - begin).count(), since_end = (until - end).count();
  for (const LightLayer& layer : layers) {
    const std::size_t sum = weights.size();
    const double here = dose * static_cast<double>(guns[layer.gun]);
    double light = 0;
    weights.push_back(0);
    for (const DecayTerm& term : layer.phosphor.terms) {
      const double left = share_left(dwell, since_end, term.tau.count());
      light += term.share * (1 - left);
      weights.push_back(static_cast<float>(here * term.share * left));
    }
    weights[sum] = static_cast<float>(here * light);
  }
}

}  // namespace kinescope
