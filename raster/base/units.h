// Units of time and rate that the display and the animation share.
#pragma once

#include <chrono>
#include <cstdint>
#include <numeric>

namespace kinescope {

/// A span or point of simulated time.
using Seconds = std::chrono::duration<double>;

constexpr Seconds microseconds(double us) { return Seconds(us * 1e-6); }
constexpr Seconds milliseconds(double ms) { return Seconds(ms * 1e-3); }

/// An exact rate in hertz, such as 60000/1001.
struct Rate {
  std::int64_t numerator = 60;
  std::int64_t denominator = 1;

  constexpr double hertz() const {
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }
  constexpr Seconds period() const {
    return Seconds(static_cast<double>(denominator) / static_cast<double>(numerator));
  }
  constexpr Rate reduced() const {
    const std::int64_t g = std::gcd(numerator, denominator);
    return g > 1 ? Rate{numerator / g, denominator / g} : *this;
  }
};

}  // namespace kinescope
