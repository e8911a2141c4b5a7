// What a real beam makes of the moves that it is asked for: amplifiers that slew, settle and ring,
// a current that rises and falls, a spot that grows with it and towards the edges.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "display/vector/beam_move.h"
#include "display/vector/deflection_axis.h"
#include "display/vector/machine.h"

namespace kinescope {

/// Turns moves into even pieces, so short that the light they leave is the real motion's, whatever
/// the current's and the beam's speed: bright ends, round corners and overshoot follow from the
/// law. The current comes later than its command by as much as the beam lags behind.
class BeamDynamics {
 public:
  explicit BeamDynamics(const VectorMachine& machine);

  /// Adds the lit pieces of [now, end).
  /// @param moves those that begin before `end` and were not yet given, in order of time
  void follow(std::span<const BeamMove> moves, Seconds end, std::vector<BeamMove>& pieces);

  /// Lets the time pass in which everything happens as it did in a time as long before.
  void repeat(Seconds length);
  /// Whether a move lies ahead that began before a time.
  bool carries_since(Seconds time) const;

  Seconds now() const { return now_; }
  /// Where the beam is now, device units.
  double x() const { return x_.place(0); }
  double y() const { return y_.place(0); }
  /// Nothing that was given lies ahead.
  bool rests() const { return commands_.empty() && currents_.empty() && current_ == 0; }

 private:
  void take_command(Seconds& until);
  float take_current(Seconds& until);
  void add_pieces(double length, float aim, std::vector<BeamMove>& pieces);
  double piece_length(double t, double sigma, float aim) const;
  float current_after(double t, float aim) const;
  float mean_current(double from, double to, float aim) const;
  float spread_at(double x, double y, float current) const;

  bool ideal_;
  double width_, height_, sigma_;  // device units
  double growth_, edge_spread_, current_tau_;
  Seconds lag_;
  Seconds now_{0};
  DeflectionAxis x_, y_;
  double rest_x_ = 0, rest_y_ = 0;
  float current_ = 0;
  BeamMove lit_;                   // whose current flows, or fades
  std::deque<BeamMove> commands_;  // not yet over
  std::deque<BeamMove> currents_;  // whose current is not yet over
};

}  // namespace kinescope
