#include "display/vector/deflection_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kinescope {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();
/// What a stage makes up for within a tenth of a nanosecond counts as caught up.
constexpr double kCaughtUp = 1e-10;
/// After so many time constants 4e-18 is left: less than rounding.
constexpr double kSettledDecays = 40;

}  // namespace

double DeflectionLaw::natural_hz() const {
  const double b = 1 - 2 * damping * damping;
  return bandwidth_khz * 1e3 / std::sqrt(b + std::sqrt(b * b + 1));
}

Seconds DeflectionLaw::lag() const {
  if (!(bandwidth_khz > 0)) return Seconds(0);
  return Seconds(2 * damping / (2 * std::numbers::pi * natural_hz()));
}

Settling::Settling(const DeflectionLaw& law) {
  if (!(law.bandwidth_khz > 0)) return;
  w_ = 2 * std::numbers::pi * law.natural_hz();
  decay_ = law.damping * w_;
  lag_ = law.lag().count();
  const double slowest =
      law.damping > 1 ? decay_ - w_ * std::sqrt(law.damping * law.damping - 1) : decay_;
  settled_time_ = kSettledDecays / std::max(slowest, 1e-30);
  short_time_ = 2 / (w_ * std::max(1.0, 2 * law.damping));
  most_acceleration_ = w_ * std::sqrt(1 + 4 * law.damping * law.damping);
  series_[1] = 1;
  for (std::size_t n = 2; n < kTerms; ++n) {
    const auto k = static_cast<double>(n);
    series_[n] = (-2 * law.damping * (k - 1) * series_[n - 1] - series_[n - 2]) / (k * (k - 1));
  }
}

Settling::Step Settling::closed_step(double t) const {
  // exp(-decay t) times cos(k t) and sin(k t) / k, of whatever kind k is.
  const double k2 = w_ * w_ - decay_ * decay_, k = std::sqrt(std::abs(k2));
  double c, s;
  if (k < 1e-6 * w_) {
    c = std::exp(-decay_ * t), s = t * c;
  } else if (k2 > 0) {
    const double left = std::exp(-decay_ * t);
    c = left * std::cos(k * t), s = left * std::sin(k * t) / k;
  } else {
    const double slow = std::exp((k - decay_) * t), fast = std::exp((-k - decay_) * t);
    c = 0.5 * (slow + fast), s = 0.5 * (slow - fast) / k;
  }
  return {s, c - decay_ * s};
}

Settling::Step Settling::short_step(double t) const {
  const double x = w_ * t;
  double answer = 0, speed = 0;  // Horner's rule, and its derivative
  for (std::size_t n = kTerms; n-- > 0;) {
    speed = speed * x + answer;
    answer = answer * x + series_[n];
  }
  return {w_ > 0 ? answer / w_ : 0, speed};
}

std::array<Settling::Step, Settling::kSteps> Settling::short_steps(
    const std::array<double, kSteps>& times) const {
  std::array<double, kSteps> x, answer{}, speed{};
  for (std::size_t i = 0; i < kSteps; ++i) x[i] = w_ * times[i];
  const double longest = *std::max_element(times.begin(), times.end());
  for (std::size_t n = longest > 0.7 * short_time_ ? kTerms : kFewTerms; n-- > 0;) {
    for (std::size_t i = 0; i < kSteps; ++i) {
      speed[i] = speed[i] * x[i] + answer[i];
      answer[i] = answer[i] * x[i] + series_[n];
    }
  }
  std::array<Step, kSteps> steps;
  const double scale = w_ > 0 ? 1 / w_ : 0;
  for (std::size_t i = 0; i < kSteps; ++i) steps[i] = {answer[i] * scale, speed[i]};
  return steps;
}

/// The integral of the oscillation follows from its law.
double Settling::mean_place(const Transient& from, const Transient& to, double time) const {
  if (w_ == 0 || !(time > 0)) return 0;
  return ((from.speed - to.speed) + 2 * decay_ * (from.place - to.place)) / (w_ * w_ * time);
}

/// The oscillation's energy only falls; y'' = -2 decay y' - w^2 y.
double Settling::most_acceleration(const Transient& x, const Transient& y) const {
  const double speed2 = x.speed * x.speed + y.speed * y.speed;
  return most_acceleration_ * std::sqrt(w_ * w_ * (x.place * x.place + y.place * y.place) + speed2);
}

DeflectionAxis::DeflectionAxis(const DeflectionLaw& law)
    : slew_(law.slew_units_us > 0 ? law.slew_units_us * 1e6 : kEver) {}

Seconds DeflectionAxis::follow(const DeflectionCommand& command, const Settling& law) {
  const double place = motion_.at + motion_.rest.place, speed = motion_.speed + motion_.rest.speed;
  command_ = command;
  double lasts = kEver;
  const double behind = command.at - stage_;
  if (slew_ == kEver || std::abs(behind) <= slew_ * kCaughtUp) {
    stage_ = command.at;
    motion_.speed = std::clamp(command.speed, -slew_, slew_);
  } else {
    motion_.speed = std::copysign(slew_, behind);
    const double until = behind / (motion_.speed - command.speed);
    if (until > 0) lasts = until;
  }
  motion_.at = stage_ - law.lag() * motion_.speed;
  motion_.rest = law.at_once() ? Transient{} : Transient{place - motion_.at, speed - motion_.speed};
  return Seconds(lasts);
}

void DeflectionAxis::advance(Seconds time, const Settling& law, const Settling::Step& step) {
  const double t = time.count();
  motion_.rest = law.after(motion_.rest, step);
  stage_ += motion_.speed * t;
  command_.at += command_.speed * t;
  // Caught up, to the last bit.
  if (std::abs(command_.at - stage_) <= slew_ * kCaughtUp && slew_ != kEver) {
    motion_.rest.place += stage_ - command_.at;
    stage_ = command_.at;
  }
  motion_.at = stage_ - law.lag() * motion_.speed;
}

}  // namespace kinescope
