// How long a stage takes.
#pragma once

#include <chrono>
#include <utility>

namespace kinescope {

class StageTimer {
 public:
  /// ms since the last call, or since it was made.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(began_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace kinescope
