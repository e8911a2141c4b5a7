#include "display/phosphor_flash.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "display/decay.h"
#include "display/layer_colours.h"

namespace kinescope {
namespace {

using Channels = std::array<float, 3>;

double luminance(const Channels& c) {
  const double r = c[0], g = c[1], b = c[2];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

}  // namespace

FlashedSpot::FlashedSpot(const PhosphorType& type, const Flash& flash)
    : type_(type), flash_(flash), colours_(layer_colours(type)) {
  whole_ = brightness(Seconds(0));
}

/// One layer's, of a dose of 1 or of a strength of 1.
double FlashedSpot::layer_light(const Phosphor& layer, const Exposure& exposure) const {
  assert(exposure.begin.count() >= 0 && exposure.end >= exposure.begin);
  const double end = flash_.length.count();
  const double begin_s = exposure.begin.count(), end_s = exposure.end.count();
  double light = 0;
  if (flash_.continuous && begin_s < end) light = std::min(end_s, end) - begin_s;
  for (const DecayTerm& term : layer.terms) {
    const double tau = term.tau.count();
    if (!flash_.continuous) {
      light += term.share * light_of_dose(begin_s, end_s, end, tau);
    } else if (end_s > end) {
      const double since = std::max(begin_s, end) - end;
      light +=
          term.share * tau * std::exp(-since / tau) * one_minus_exp((end_s - end - since) / tau);
    }
  }
  return light;
}

LinearRgb FlashedSpot::light(const Exposure& exposure) const {
  LinearRgb sum;
  for (std::size_t i = 0; i < type_.layers.size(); ++i) {
    const float light = static_cast<float>((flash_.continuous ? 1 : flash_.dose) *
                                           layer_light(type_.layers[i], exposure));
    sum.r += light * colours_[i][0];
    sum.g += light * colours_[i][1];
    sum.b += light * colours_[i][2];
  }
  return sum;
}

double FlashedSpot::layer_brightness(std::size_t layer, Seconds t) const {
  const Phosphor& phosphor = type_.layers[layer];
  return flash_.continuous ? phosphor.decay_after_steady(t)
                           : phosphor.decay_after_pulse(flash_.length, t);
}

double FlashedSpot::brightness(Seconds t) const {
  double light = 0;
  for (std::size_t i = 0; i < type_.layers.size(); ++i) {
    light += luminance(colours_[i]) * layer_brightness(i, t);
  }
  return light / whole_;
}

LinearRgb FlashedSpot::hue(Seconds t) const {
  float sum[3] = {};
  for (std::size_t i = 0; i < type_.layers.size(); ++i) {
    const double light = layer_brightness(i, t) / whole_;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += colours_[i][c] * static_cast<float>(light);
  }
  const float most = std::max({sum[0], sum[1], sum[2]});
  if (!(most > 0)) return {};
  const auto channel = [&](std::size_t c) { return std::max(0.0f, sum[c] / most); };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace kinescope
