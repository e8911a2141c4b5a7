// Time as the video controller counts it: pixel clocks, exact.
#pragma once

#include <cmath>
#include <cstdint>

#include "raster/base/fixed.h"
#include "raster/base/units.h"

namespace kinescope {

/// Pixel clocks with 10 binary places: sums and differences are exact for thousands of years.
using BeamTime = Fixed<10, std::int64_t>;

constexpr BeamTime clocks(std::int64_t count) { return BeamTime::from_raw(count * BeamTime::kOne); }

constexpr double to_clocks(BeamTime t) {
  return static_cast<double>(t.raw()) / static_cast<double>(BeamTime::kOne);
}

/// Between seconds and pixel clocks; seconds are rounded to the nearest 1/1024 of a clock, so that
/// a time computed in floating point falls on the pixel that was meant.
class BeamClock {
 public:
  explicit BeamClock(double pixel_clock_hz) : hz_(pixel_clock_hz) {}
  BeamTime at(Seconds t) const {
    return BeamTime::from_raw(std::llround(t.count() * hz_ * static_cast<double>(BeamTime::kOne)));
  }
  Seconds seconds(BeamTime t) const { return Seconds(to_clocks(t) / hz_); }

 private:
  double hz_;
};

/// How often `period` fits into `t` before it, and the rest in [0, period).
struct Periods {
  std::int64_t whole = 0;
  BeamTime rest;
};
constexpr Periods divide(BeamTime t, BeamTime period) {
  std::int64_t whole = t.raw() / period.raw();
  if (t.raw() % period.raw() < 0) --whole;
  return {whole, BeamTime::from_raw(t.raw() - whole * period.raw())};
}

}  // namespace kinescope
