// The transport: pause, single steps and slow motion, as a user's keys ask for them.
#pragma once

#include <string>

#include "raster/base/units.h"

namespace kinescope {

enum class Move { kNone, kForward, kBack };

/// Space pauses; `.` and `,` pause and step; `[` and `]` slow time down and speed it up.
class Transport {
 public:
  static constexpr double kSlowest = 1e-5;

  explicit Transport(double time_scale = 1);
  /// Each press of a step's key is a step, however many come between two ticks. A key that is held,
  /// `repeated`, steps on as fast as the steps are done; it does not pause in turns.
  /// @return whether `key` was one of its own
  bool answer(const std::string& key, bool repeated = false);
  /// What to do in this tick. A single step is done once for each press.
  Move next();

  bool paused() const { return paused_; }
  /// Whether the next tick is a single step.
  bool steps_once() const { return single_steps_ != 0; }
  /// Simulated seconds a second: 1, 1/2, 1/5, 1/10 ... 1/100000.
  double time_scale() const;
  /// "1x", "1/2000x".
  std::string text() const;
  /// Simulated time of one tick, which lasts one refresh period of the demo's display.
  Seconds step_length(Rate refresh) const { return refresh.period() * time_scale(); }

 private:
  int slowdown_ = 0;  // place in 1, 2, 5, 10, 20 ...
  bool paused_ = false;
  int single_steps_ = 0;  // asked for and not done; back: below 0
};

}  // namespace kinescope
