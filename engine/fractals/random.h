// Random numbers that are the same on every machine for one seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace kinescope {

/// The standard fixes what its engines yield, but not what its distributions make of it: so these
/// are our own.
class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Of mean 0 and variance 1. Source: Box and Muller, 1958.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace kinescope
