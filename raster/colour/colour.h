// Colours, linear or encoded, each with a type of its own, and the sRGB curve between them.
// Source: IEC 61966-2-1.
#pragma once

#include <cstdint>

namespace kinescope {

/// Linear light; 1 is white.
struct LinearRgb {
  float r = 0, g = 0, b = 0;
  bool operator==(const LinearRgb&) const = default;
};

/// Linear light with coverage, not premultiplied; 1 is white and opaque.
struct LinearRgba {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const LinearRgba&) const = default;
};

/// Light encoded by the sRGB curve; alpha is linear. As in a PNG file, and what a window takes.
struct Srgb8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Srgb8&) const = default;
};

/// The same with 16 bits a channel.
struct Srgb16 {
  std::uint16_t r = 0, g = 0, b = 0, a = 65535;
  bool operator==(const Srgb16&) const = default;
};

/// Linear light in 8 bits, the plain RGBA8 of graphics interfaces (for benchmarks).
struct Linear8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Linear8&) const = default;
};

/// The sRGB curve on one channel; the argument is clamped to [0, 1], NaN gives 0.
float srgb_encode(float linear);
float srgb_decode(float encoded);

Srgb8 encode_srgb8(LinearRgba colour);
Srgb8 encode_srgb8(LinearRgb colour);
Srgb16 encode_srgb16(LinearRgb colour);
LinearRgba decode(Srgb8 colour);

}  // namespace kinescope
