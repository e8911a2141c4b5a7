// Lines clipped by region codes, one crossing a step.
// Source: Newman and Sproull, "Principles of Interactive Computer Graphics", 1979, ch. 5.
#pragma once

#include <optional>

#include "engine/clip/outcode.h"

namespace kinescope {

enum class ClipState { kRunning, kAccepted, kRejected };

/// Between calls of next() the members say what the algorithm knows.
class CohenSutherland {
 public:
  /// Rejects at once what is not finite.
  CohenSutherland(const ClipWindow& window, const Segment2& line);

  /// Decides, or moves one end to a side of the window; false once decided.
  bool next();

  Segment2 segment;            ///< what is left
  Outcode from_code, to_code;  ///< of its ends
  ClipState state;
  Outcode side = 0;         ///< the side at which the last step cut; 0 for none
  bool moved_from = false;  ///< which end that step moved
  int steps = 0;

 private:
  ClipWindow window_;
  Segment2 line_;
};

/// The part inside, if there is any. A point on a side, or a line along one, is inside.
std::optional<Segment2> clip_cohen_sutherland(const ClipWindow& window, const Segment2& line);

}  // namespace kinescope
