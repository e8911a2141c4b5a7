// The knobs on the back of a tube: each turns one of its settings away from the preset's.
#pragma once

#include <span>
#include <string_view>

#include "display/tube/settings.h"

namespace kinescope {

/// One knob: its keys, its range, and what it does to a preset.
struct TubeDial {
  std::string_view name, down, up;
  double least, most, step, start;  ///< `start` leaves the preset as it is
  std::string_view unit, about;
  void (*turn)(TubeSettings&, double);
};
std::span<const TubeDial> tube_dials();

/// The middle of the tube, that many times as large: the same spot, mask and lines, seen closer.
TubeSettings magnified(TubeSettings settings, double times);

}  // namespace kinescope
