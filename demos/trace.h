// The trace of a demo: every step it was given. Whoever has it can play the demo again.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "demos/demo.h"

namespace kinescope {

class Trace {
 public:
  std::int64_t steps() const { return steps_; }
  /// Simulated time after all steps.
  Seconds end() const { return time_of(steps_); }
  void add(Seconds length, std::vector<InputEvent> events);
  /// Forgets all but the first `steps` steps.
  void cut(std::int64_t steps);
  Step step(std::int64_t index) const;

 private:
  /// Steps of equal length. Times are products, not sums: whole periods stay whole for hours.
  struct Run {
    std::int64_t first;
    Seconds begin;
    Seconds length;
  };
  const Run* run_of(std::int64_t index) const;
  Seconds time_of(std::int64_t index) const;

  std::vector<Run> runs_;
  std::map<std::int64_t, std::vector<InputEvent>> events_;  // steps without events are left out
  std::int64_t steps_ = 0;
};

}  // namespace kinescope
