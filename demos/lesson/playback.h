// How far a lesson has played: by itself at a speed, or step by step by the user's keys.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace kinescope {

class Playback {
 public:
  static const std::vector<std::string>& speeds() {
    static const std::vector<std::string> kNames = {"1/s",   "2/s",    "5/s",     "15/s",   "60/s",
                                                    "300/s", "2000/s", "20000/s", "at once"};
    return kNames;
  }

  /// Moves on by that much time; @return whether another number of steps is shown
  bool pass(double seconds, int speed, std::size_t steps) {
    const std::size_t before = shown();
    constexpr std::array kSpeeds = {1.0, 2.0, 5.0, 15.0, 60.0, 300.0, 2000.0, 20000.0, HUGE_VAL};
    const double end = static_cast<double>(steps);
    position_ = std::min(position_ + seconds * kSpeeds[static_cast<std::size_t>(speed)], end);
    return shown() != before;
  }
  void step_by(int count, std::size_t steps) {
    const double at = std::floor(position_) + count;
    position_ = std::clamp(at, 0.0, static_cast<double>(steps));
  }
  void go_to(std::size_t step) { position_ = static_cast<double>(step); }
  std::size_t shown() const { return static_cast<std::size_t>(position_ + 1e-9); }

 private:
  double position_ = 0;
};

}  // namespace kinescope
