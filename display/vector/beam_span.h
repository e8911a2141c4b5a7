// What a beam does while nothing that is asked of it changes, and the pieces of light it leaves.
#pragma once

#include <array>

#include "display/vector/beam_stroke.h"
#include "display/vector/deflection_axis.h"
#include "raster/base/units.h"

namespace kinescope {

/// Device units, seconds.
struct BeamSpan {
  Seconds at{0};                         ///< when its motion began
  double from = 0, to = 0;               ///< after that: how long the current flows, or fades
  AxisMotion x, y;                       ///< since `at`
  float current = 0, aim = 0;            ///< at `from`, and what it comes to
  std::array<float, 3> colour{1, 1, 1};  ///< as a move's
  float spread = 1;                      ///< times the spot's usual width

  Seconds begin() const { return at + Seconds(from); }
  Seconds end() const { return at + Seconds(to); }
};

/// Light of a short while: an even stroke, or a few spots whose sum is it.
struct BeamPiece {
  double from = 0, to = 0;                        ///< after the span's motion began, seconds
  float current = 0;                              ///< the mean one
  int spots = 0;                                  ///< 0: an even stroke from place 0 to place 1
  std::array<double, BeamSpots::kMost> x{}, y{};  ///< device units
  std::array<float, BeamSpots::kMost> share{}, spread{};
};

}  // namespace kinescope
