// Lines clipped by their parameter, one side of the window a step.
// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", 1984.
#pragma once

#include <optional>

#include "engine/clip/cohen_sutherland.h"

namespace kinescope {

class LiangBarsky {
 public:
  /// Rejects at once what is not finite.
  LiangBarsky(const ClipWindow& window, const Segment2& line);

  /// Treats the next side: left, right, below, above. False once decided.
  bool next();

  double enter = 0.0, leave = 1.0;  ///< the parameters between which the line may be inside
  int side = -1;                    ///< the side last treated, 0 to 3
  double p = 0.0, q = 0.0;          ///< of that side: inside where t p <= q
  ClipState state;

  /// From enter to leave; an end that was not cut is given back to the bit.
  Segment2 segment() const;

 private:
  ClipWindow window_;
  Segment2 line_;
};

std::optional<Segment2> clip_liang_barsky(const ClipWindow& window, const Segment2& line);

}  // namespace kinescope
