// One axis of a beam's deflection: a stage whose speed is limited, and an amplifier of the second
// order behind it. Exact in time: the stage's output is made of straight pieces, and the
// amplifier's answer to each has a closed form.
#pragma once

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

/// A command that changes evenly from `at`, units, units a second.
struct DeflectionCommand {
  double at = 0, speed = 0;
};

class DeflectionAxis {
 public:
  explicit DeflectionAxis(const DeflectionLaw& law, double at = 0);

  /// Puts a command before the stage, from now on. @return for how long the stage's output is
  /// straight: then, or when the command changes, it must be put anew
  Seconds follow(const DeflectionCommand& command);

  /// After a time within what follow() told, seconds: the beam, its speed, and a bound of its
  /// acceleration from then on.
  double place(double t) const;
  double speed(double t) const;
  double most_acceleration(double t) const;
  /// The mean place between two times.
  double mean_place(double from, double to) const;

  /// Lets the time pass.
  void advance(Seconds time);

 private:
  struct Motion {
    double place, speed;
  };
  Motion transient(double t) const;
  double stage(double t) const { return stage_ + stage_speed_ * t; }

  double w_ = 0, decay_ = 0;  // 1/s
  double damping_, slew_;     // units a second
  double stage_, stage_speed_ = 0;
  double y_ = 0, y_speed_ = 0;  // the beam less where it would be in the end
  DeflectionCommand command_;
};

}  // namespace kinescope
