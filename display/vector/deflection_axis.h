// One axis of a beam's deflection: a stage whose speed is limited, and an amplifier of the second
// order behind it. Exact in time: the stage's output is made of straight pieces, and the
// amplifier's answer to each has a closed form.
#pragma once

#include <array>

#include "raster/base/units.h"

namespace kinescope {

/// x'' = w^2 (u - x) - 2 damping w x', where u follows the command no faster than the slew rate.
struct DeflectionLaw {
  double bandwidth_khz = 0;  ///< at -3 dB; 0: follows at once
  double damping = 0.7;      ///< share of critical damping; below 1 the beam rings
  double slew_units_us = 0;  ///< 0: no limit

  /// w / 2 pi = what the amplifier rings at if nothing damps it, of the -3 dB point.
  double natural_hz() const;
  /// By which an even motion lags behind its command.
  Seconds lag() const;
};

/// A motion that fades: the beam, less where it would be if it had settled. Units, units a second.
struct Transient {
  double place = 0, speed = 0;
};

/// How transients fade: y'' = -2 damping w y' - w^2 y, whatever kind its roots are.
class Settling {
 public:
  /// What carries any transient on by one time: the law's answer to a kick of one unit a second,
  /// and its speed.
  struct Step {
    double answer, speed;
  };

  explicit Settling(const DeflectionLaw& law);

  Step step(double t) const {
    if (t > settled_time_) return {0, 0};
    return t <= short_time_ ? short_step(t) : closed_step(t);
  }
  /// In closed form.
  Step closed_step(double t) const;
  /// By its Taylor series, without exp or sin, to 1e-7: up to short_time(), a few times shorter
  /// than an oscillation.
  Step short_step(double t) const;
  double short_time() const { return short_time_; }
  /// Short steps of several times at once.
  static constexpr std::size_t kSteps = 8;
  std::array<Step, kSteps> short_steps(const std::array<double, kSteps>& times) const;
  double place_after(const Transient& y, const Step& step) const {
    return y.place * (step.speed + 2 * decay_ * step.answer) + y.speed * step.answer;
  }
  Transient after(const Transient& y, const Step& step) const {
    return {place_after(y, step), y.speed * step.speed - w_ * w_ * y.place * step.answer};
  }
  /// The mean place of the time in which one transient became another.
  double mean_place(const Transient& from, const Transient& to, double time) const;
  /// A bound of the acceleration of both axes together from now on.
  double most_acceleration(const Transient& x, const Transient& y) const;
  double acceleration(const Transient& y) const {
    return -2 * decay_ * y.speed - w_ * w_ * y.place;
  }
  /// Behind its command, of an even motion of one unit a second.
  double lag() const { return lag_; }
  bool at_once() const { return w_ == 0; }

 private:
  static constexpr std::size_t kTerms = 16, kFewTerms = 13;  // as exact up to 0.7 of short_time()
  double w_ = 0, decay_ = 0;                                 // 1/s
  double lag_ = 0, short_time_ = 1e30, settled_time_ = 0, most_acceleration_ = 0;
  std::array<double, kTerms> series_{};  // of the answer times w, in powers of w t
};

/// A command that changes evenly from `at`, units, units a second.
struct DeflectionCommand {
  double at = 0, speed = 0;
};

/// What an axis does from some time on: an even motion and what has not settled yet.
struct AxisMotion {
  double at = 0, speed = 0;
  Transient rest;
};

class DeflectionAxis {
 public:
  explicit DeflectionAxis(const DeflectionLaw& law);

  /// Puts a command before the stage, from now on. @return for how long the stage's output is
  /// straight: then, or when the command changes, it must be put anew
  Seconds follow(const DeflectionCommand& command, const Settling& law);
  /// From now on, as long as follow() told.
  const AxisMotion& motion() const { return motion_; }
  /// Lets time pass. @param step of that time
  void advance(Seconds time, const Settling& law, const Settling::Step& step);

 private:
  double slew_;  // units a second
  double stage_ = 0;
  AxisMotion motion_;
  DeflectionCommand command_;
};

}  // namespace kinescope
