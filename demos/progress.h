// A progress bar on standard error, for a person who waits.
#pragma once

#include <chrono>
#include <string>

namespace kinescope {

/// Shows itself only on a terminal, and only once the work has lasted half a second. Plain
/// characters, no colour (so NO_COLOR holds always).
class Progress {
 public:
  /// @param total 0 if it is not known
  /// @param shown false keeps it silent (--quiet)
  Progress(std::string what, int total, bool shown);
  ~Progress();  ///< wipes the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void done(int count);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  int total_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace kinescope
