#include "demos/transport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

constexpr int kSlowestPlace = 15;  // three places a decade

double slowdown(int place) {
  constexpr double kMantissa[] = {1, 2, 5};
  return kMantissa[place % 3] * std::pow(10.0, place / 3);
}

}  // namespace

Transport::Transport(double time_scale) {
  while (slowdown_ < kSlowestPlace && slowdown(slowdown_) * time_scale < 0.999) ++slowdown_;
}

bool Transport::answer(const std::string& key, bool repeated) {
  if (key == "Space") {
    if (!repeated) paused_ = !paused_, single_steps_ = 0;
  } else if (key == "." || key == ",") {
    paused_ = true;
    if (!repeated || single_steps_ == 0) single_steps_ += key == "." ? 1 : -1;
  } else if (key == "[" || key == "]") {
    slowdown_ = std::clamp(slowdown_ + (key == "[" ? 1 : -1), 0, kSlowestPlace);
  } else {
    return false;
  }
  return true;
}

Move Transport::next() {
  if (single_steps_ > 0) return --single_steps_, Move::kForward;
  if (single_steps_ < 0) return ++single_steps_, Move::kBack;
  return paused_ ? Move::kNone : Move::kForward;
}

double Transport::time_scale() const { return 1 / slowdown(slowdown_); }

std::string Transport::text() const {
  return slowdown_ == 0 ? "1x" : fmt::format("1/{:.0f}x", slowdown(slowdown_));
}

}  // namespace kinescope
