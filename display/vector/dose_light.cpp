#include "display/vector/dose_light.h"

#include <algorithm>
#include <cmath>

#include "display/decay.h"
#include "display/layer_colours.h"

namespace kinescope {
namespace {

/// After so many time constants what is left, 3e-7 of a term's share, is given out at once.
constexpr double kGone = 15;
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

DoseLight::DoseLight(const PhosphorType& type, bool by_guns) {
  const auto colours = layer_colours(type);
  for (std::size_t i = 0; i < type.layers.size(); ++i) {
    layers_.push_back({type.layers[i], colours[i], by_guns ? i : 0, planes_});
    planes_ += 1 + static_cast<int>(type.layers[i].terms.size());
    for (const DecayTerm& term : type.layers[i].terms) {
      slowest_ = std::max(slowest_, term.tau.count());
    }
  }
}

void DoseLight::add_weights(double dose, const std::array<float, 3>& guns, Seconds begin,
                            Seconds end, Seconds until, std::vector<float>& weights) const {
  const double dwell = (end - begin).count(), since_end = (until - end).count();
  const std::size_t first = weights.size();
  weights.resize(first + static_cast<std::size_t>(planes_));
  const bool all_gone = since_end > kGone * slowest_;
  for (const LightLayer& layer : layers_) {
    float* weight = &weights[first + static_cast<std::size_t>(layer.first_plane)];
    float& sum = *weight;
    const double here = dose * static_cast<double>(guns[layer.gun]);
    double light = all_gone ? 1 : 0;
    for (const DecayTerm& term : layer.phosphor.terms) {
      if (all_gone) break;
      const double left = term.share * share_left(dwell, since_end, term.tau.count());
      light += term.share - left;
      *++weight = static_cast<float>(here * left);
    }
    sum = static_cast<float>(here * light);
  }
}

}  // namespace kinescope
