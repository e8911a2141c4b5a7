// Fixed-point numbers with their format in their type.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace kinescope {

/// A signed fixed-point number with kFractionBits binary places, kept in Rep.
template <int kFractionBits, typename Rep = std::int32_t>
class Fixed {
 public:
  static constexpr int kBits = kFractionBits;
  static constexpr Rep kOne = Rep{1} << kFractionBits;

  constexpr Fixed() = default;
  static constexpr Fixed from_raw(Rep raw) {
    Fixed f;
    f.raw_ = raw;
    return f;
  }
  static constexpr Fixed from_int(int v) { return from_raw(static_cast<Rep>(v) * kOne); }
  /// Rounds to nearest, ties to even (the mode that SIMD conversions use).
  static Fixed from_float(float v) {
    return from_raw(static_cast<Rep>(std::nearbyint(v * static_cast<float>(kOne))));
  }

  constexpr Rep raw() const { return raw_; }
  constexpr float to_float() const {
    return static_cast<float>(raw_) * (1.0f / static_cast<float>(kOne));
  }
  constexpr int floor() const { return static_cast<int>(raw_ >> kFractionBits); }
  constexpr int ceil() const { return static_cast<int>((raw_ + kOne - 1) >> kFractionBits); }

  constexpr Fixed operator+(Fixed o) const { return from_raw(raw_ + o.raw_); }
  constexpr Fixed operator-(Fixed o) const { return from_raw(raw_ - o.raw_); }
  constexpr Fixed operator-() const { return from_raw(-raw_); }
  constexpr auto operator<=>(const Fixed&) const = default;

 private:
  Rep raw_ = 0;
};

/// Device coordinates of the rasterizer: pixels with 8 binary places.
using Fixed24_8 = Fixed<8>;

}  // namespace kinescope
