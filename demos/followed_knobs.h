// Which knobs have been turned since a demo last looked.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "demos/knob.h"

namespace kinescope {

class FollowedKnobs {
 public:
  /// Takes the knobs as they are now. @return whether any has been turned; at first, yes
  bool follow(std::span<const Knob> knobs) {
    before_ = std::move(now_);
    now_.clear();
    for (const Knob& knob : knobs) now_.push_back(knob.value);
    return now_ != before_;
  }
  /// Whether this one was turned, by the last call of follow(); at first, yes.
  bool turned(int knob) const {
    const auto i = static_cast<std::size_t>(knob);
    return before_.empty() || now_[i] != before_[i];
  }
  /// All count as turned the next time.
  void forget() { now_.clear(); }

 private:
  std::vector<double> before_, now_;
};

}  // namespace kinescope
