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

}  // namespace

double DeflectionLaw::natural_hz() const {
  const double b = 1 - 2 * damping * damping;
  return bandwidth_khz * 1e3 / std::sqrt(b + std::sqrt(b * b + 1));
}

Seconds DeflectionLaw::lag() const {
  if (!(bandwidth_khz > 0)) return Seconds(0);
  return Seconds(2 * damping / (2 * std::numbers::pi * natural_hz()));
}

DeflectionAxis::DeflectionAxis(const DeflectionLaw& law, double at)
    : damping_(law.damping),
      slew_(law.slew_units_us > 0 ? law.slew_units_us * 1e6 : kEver),
      stage_(at) {
  if (law.bandwidth_khz > 0) w_ = 2 * std::numbers::pi * law.natural_hz();
  decay_ = damping_ * w_;
}

Seconds DeflectionAxis::follow(const DeflectionCommand& command) {
  const Motion now{place(0), speed(0)};
  command_ = command;
  double lasts = kEver;
  const double behind = command.at - stage_;
  if (slew_ == kEver || std::abs(behind) <= slew_ * kCaughtUp) {
    stage_ = command.at;
    stage_speed_ = std::clamp(command.speed, -slew_, slew_);
  } else {
    stage_speed_ = std::copysign(slew_, behind);
    const double until = behind / (stage_speed_ - command.speed);
    if (until > 0) lasts = until;
  }
  if (w_ > 0) {
    y_ = now.place - (stage_ - 2 * damping_ / w_ * stage_speed_);
    y_speed_ = now.speed - stage_speed_;
  }
  return Seconds(lasts);
}

/// What is left of an oscillation that fades.
DeflectionAxis::Motion DeflectionAxis::transient(double t) const {
  if (w_ == 0 || (y_ == 0 && y_speed_ == 0)) return {0, 0};
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
  return {y_ * c + (y_speed_ + decay_ * y_) * s,
          y_speed_ * c - (w_ * w_ * y_ + decay_ * y_speed_) * s};
}

double DeflectionAxis::place(double t) const {
  const double lag = w_ > 0 ? 2 * damping_ / w_ * stage_speed_ : 0;
  return stage(t) - lag + transient(t).place;
}

double DeflectionAxis::speed(double t) const { return stage_speed_ + transient(t).speed; }

/// The oscillation's energy only falls; y'' = -2 decay y' - w^2 y.
double DeflectionAxis::most_acceleration(double t) const {
  const Motion y = transient(t);
  return w_ * std::sqrt(1 + 4 * damping_ * damping_) * std::hypot(w_ * y.place, y.speed);
}

/// The integral of the oscillation follows from its law.
double DeflectionAxis::mean_place(double from, double to) const {
  const double straight = 0.5 * (place(from) + place(to));
  if (w_ == 0 || !(to > from)) return straight;
  const Motion a = transient(from), b = transient(to);
  const double sum = ((a.speed - b.speed) + 2 * decay_ * (a.place - b.place)) / (w_ * w_);
  return straight - 0.5 * (a.place + b.place) + sum / (to - from);
}

void DeflectionAxis::advance(Seconds time) {
  const double t = time.count();
  const Motion y = transient(t);
  y_ = y.place, y_speed_ = y.speed;
  stage_ = stage(t);
  command_.at += command_.speed * t;
  // Caught up, to the last bit.
  if (std::abs(command_.at - stage_) <= slew_ * kCaughtUp && slew_ != kEver) {
    y_ += stage_ - command_.at;
    stage_ = command_.at;
  }
}

}  // namespace kinescope
