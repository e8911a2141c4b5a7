// One spot of phosphor, excited once: its light, colour and brightness at any time after.
#pragma once

#include <array>

#include "display/exposure.h"
#include "display/phosphor.h"

namespace kinescope {

/// Even excitation, of rested phosphor from time 0, or without a beginning.
struct Flash {
  Seconds length{0};  ///< ends at this time
  bool continuous = false;
  double dose = 1;  ///< of a flash with a beginning; one without has a strength of 1 a second
};

class FlashedSpot {
 public:
  /// The type must outlive it.
  FlashedSpot(const PhosphorType& type, const Flash& flash);

  /// The light of an exposure that begins at 0 or later; with all layers lit evenly, the light of a
  /// dose of 1 is a linear sRGB whose largest channel is 1.
  LinearRgb light(const Exposure& exposure) const;
  /// Luminance t after the excitation ended, as a share of that when it ended.
  double brightness(Seconds t) const;
  /// The colour of the light t after the excitation ended: its largest channel is 1, and channels
  /// out of gamut are 0.
  LinearRgb hue(Seconds t) const;

 private:
  double layer_light(const Phosphor& layer, const Exposure& exposure) const;
  double layer_brightness(std::size_t layer, Seconds t) const;

  const PhosphorType& type_;
  Flash flash_;
  std::array<std::array<float, 3>, 3> colours_;
  double whole_ = 1;  // luminance when the excitation ends
};

}  // namespace kinescope
