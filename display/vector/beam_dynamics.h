// What a real beam makes of the moves that it is asked for: amplifiers that slew, settle and ring,
// a current that rises and falls.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "display/vector/beam_move.h"
#include "display/vector/beam_span.h"
#include "display/vector/deflection_axis.h"
#include "display/vector/machine.h"

namespace kinescope {

/// Turns moves into spans of time in which one law holds; BeamCutter tells their light, whatever
/// the current's and the beam's speed: bright ends, round corners and overshoot follow from the
/// law. The current comes later than its command by as much as the beam lags behind.
class BeamDynamics {
 public:
  explicit BeamDynamics(const VectorMachine& machine);

  /// Adds the lit spans of [now, end); where nothing limits the beam, each move whole.
  /// @param moves those that begin before `end` and were not yet given, in order of time
  void follow(std::span<const BeamMove> moves, Seconds end, std::vector<BeamSpan>& spans);

  /// Lets the time pass in which everything happens as it did in a time as long before.
  void repeat(Seconds length);
  /// Whether a move lies ahead that began before a time.
  bool carries_since(Seconds time) const;

  Seconds now() const { return now_; }
  /// Where the beam is now, device units.
  double x() const { return place_of(x_); }
  double y() const { return place_of(y_); }
  /// Nothing that was given lies ahead.
  bool rests() const { return commands_.empty() && currents_.empty() && current_ == 0; }

 private:
  void take_command();
  float take_current(Seconds& until);
  void add_span(Seconds end, float aim, std::vector<BeamSpan>& spans) const;
  double place_of(const DeflectionAxis& axis) const;

  bool ideal_;
  double current_tau_;
  Settling settling_;
  Seconds lag_;
  Seconds now_{0};
  DeflectionAxis x_, y_;
  Seconds axes_from_{0}, axes_until_{0};  // when their motion began, and until when it holds
  double rest_x_ = 0, rest_y_ = 0;
  float current_ = 0;
  BeamMove lit_;                   // whose current flows, or fades
  std::deque<BeamMove> commands_;  // not yet over
  std::deque<BeamMove> currents_;  // whose current is not yet over
};

}  // namespace kinescope
