// What covers a pixel, and how it joins what is there. These are the readable references; the
// kernels do the same to eight pixels at a time (ink-inl.h).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "raster/colour/colour.h"

namespace kinescope {

/// How light joins what is below, each by coverage times the colour's alpha.
enum class Mixing {
  kOver,  ///< takes its place; the pixel's alpha tends to 1 likewise (right for opaque pictures)
  kAdd,   ///< is added to it, as a beam does; alpha stays
};

struct Ink {
  LinearRgba colour;
  Mixing mixing = Mixing::kOver;
};

namespace ink {

/// Within [0, 1]; NaN gives 0.
inline float unit(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

/// An ink for pixels of 8 bits: colour codes, and alpha as a factor to shares of 2^15.
struct Codes {
  static constexpr float kOne = 32767;
  /// Added to a share, rounds it to a whole number in the low bits.
  static constexpr float kRound = 3 << 22;
  std::int32_t r, g, b, a;
  float alpha;
  Mixing mixing;

  explicit Codes(const Ink& ink)
      : r(code(ink.colour.r)),
        g(code(ink.colour.g)),
        b(code(ink.colour.b)),
        a(ink.mixing == Mixing::kOver ? 255 : 0),
        alpha(unit(ink.colour.a) * kOne),
        mixing(ink.mixing) {}

 private:
  static std::int32_t code(float value) {
    return static_cast<std::int32_t>(unit(value) * 255 + 0.5f);
  }
};

/// @param coverage in [0, 1]
inline void lay(const Codes& ink, float coverage, Linear8& pixel) {
  const float rounded = coverage * ink.alpha + Codes::kRound;
  const auto share = static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(rounded) & 0xffff);
  const auto mixed = [&](std::uint8_t under, std::int32_t code) {
    const bool over = ink.mixing == Mixing::kOver;
    const std::int32_t change = over ? code - under : code;
    const std::int32_t sum = under + ((2 * change * share + 32768) >> 16);
    return static_cast<std::uint8_t>(std::min(sum, 255));
  };
  pixel = {mixed(pixel.r, ink.r), mixed(pixel.g, ink.g), mixed(pixel.b, ink.b),
           mixed(pixel.a, ink.a)};
}

/// An ink for pixels of floats.
struct Light {
  LinearRgba colour;  ///< alpha as the pixel's shall become
  float alpha;
  Mixing mixing;

  explicit Light(const Ink& ink)
      : colour(ink.colour), alpha(unit(ink.colour.a)), mixing(ink.mixing) {
    colour.a = mixing == Mixing::kOver ? 1.0f : 0.0f;
  }
};

inline void lay(const Light& ink, float coverage, LinearRgba& pixel) {
  const float share = coverage * ink.alpha;
  if (share == 0) return;  // whatever the pixel holds
  if (share == 1 && ink.mixing == Mixing::kOver) {
    pixel = ink.colour;
    return;
  }
  const auto mixed = [&](float under, float light) {
    return under + (ink.mixing == Mixing::kOver ? light - under : light) * share;
  };
  pixel = {mixed(pixel.r, ink.colour.r), mixed(pixel.g, ink.colour.g), mixed(pixel.b, ink.colour.b),
           mixed(pixel.a, ink.colour.a)};
}

/// Which form of ink a kind of pixel takes.
template <typename Pixel>
struct FormFor;
template <>
struct FormFor<Linear8> {
  using Type = Codes;
};
template <>
struct FormFor<LinearRgba> {
  using Type = Light;
};

}  // namespace ink
}  // namespace kinescope
