// A light pen: a photocell before the screen. It sees the flash of what is drawn in its field, not
// the afterglow, so that it tells which instruction is being carried out.
#pragma once

#include <optional>
#include <vector>

#include "display/vector/beam_move.h"

namespace kinescope {

struct BeamPen {
  double x = 0, y = 0;         ///< middle of its field, device units
  double radius = 8;           ///< of its field, device units
  double threshold_us = 0.05;  ///< full current for so long within the field sets it off
};

/// What a pen saw, and who drew it.
struct BeamPenHit {
  Address address = 0;         ///< of the instruction that drew it
  std::vector<Address> calls;  ///< of the calls that led there, the outermost first
  double x = 0, y = 0;         ///< where the beam was
  Seconds time{0};             ///< when the pen had seen enough
};

/// When a move sets the pen off, and where the beam is then; none if it does not.
struct BeamPenSight {
  Seconds time;
  double x, y;
};
std::optional<BeamPenSight> see(const BeamPen& pen, const BeamMove& move);

}  // namespace kinescope
