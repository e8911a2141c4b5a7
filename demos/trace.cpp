#include "demos/trace.h"

#include <algorithm>

namespace kinescope {

void Trace::add(Seconds length, std::vector<InputEvent> events) {
  if (runs_.empty() || runs_.back().length != length) runs_.push_back({steps_, end(), length});
  if (!events.empty()) events_[steps_] = std::move(events);
  ++steps_;
}

void Trace::cut(std::int64_t steps) {
  steps_ = std::min(steps_, steps);
  while (!runs_.empty() && runs_.back().first >= steps_) runs_.pop_back();
  events_.erase(events_.lower_bound(steps_), events_.end());
}

Step Trace::step(std::int64_t index) const {
  Step step{{time_of(index), time_of(index + 1)}, {}};
  const auto found = events_.find(index);
  if (found != events_.end()) step.events = found->second;
  return step;
}

const Trace::Run* Trace::run_of(std::int64_t index) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), index,
                                      [](std::int64_t i, const Run& run) { return i < run.first; });
  return after == runs_.begin() ? nullptr : &*(after - 1);
}

Seconds Trace::time_of(std::int64_t index) const {
  // The end of the step before, so that a run's first step begins where the run before it ended.
  const Run* run = run_of(index - 1);
  if (run == nullptr) return Seconds(0);
  return run->begin + static_cast<double>(index - run->first) * run->length;
}

}  // namespace kinescope
