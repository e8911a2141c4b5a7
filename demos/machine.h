// What a run costs: memory and time, for --json.
#pragma once

#include <chrono>
#include <string_view>
#include <vector>

#include "demos/json.h"

namespace kinescope {

/// Largest resident memory of this process so far, MiB.
double peak_memory_mib();
/// Memory that can still be had, bytes: the system's and the control group's limit.
double available_memory_bytes();

/// Milliseconds of the frames of one stage.
class Stopwatch {
 public:
  void start() { start_ = Clock::now(); }
  void stop();
  double total_ms() const;
  /// Writes an object: {"min": .., "median": .., "max": ..}.
  void write(JsonWriter& json) const;
  /// 0 if nothing was timed.
  double median_ms() const;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  std::vector<double> ms_;
};

}  // namespace kinescope
