// Pixmaps of few bits a pixel: bitmaps of black and white, greys of up to 3 bits, and colours whose
// bits red, green and blue share.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, 4.3.
#pragma once

#include <cstdint>

#include "raster/colour/colour.h"

namespace kinescope {

/// Bits of each channel. Green gets the first odd one, red the second, as in 3-3-2 and 5-6-5.
struct ChannelBits {
  int red, green, blue;
};
constexpr ChannelBits channel_bits(int bits) {
  return {bits / 3 + (bits % 3 == 2), bits / 3 + (bits % 3 != 0), bits / 3};
}

/// The nearest of 2^bits evenly spaced codes. @param bits 1 to 8
constexpr std::uint8_t nearest_level(int code, int bits) {
  const int most = (1 << bits) - 1, level = (code * most * 2 + 255) / 510;
  return static_cast<std::uint8_t>((level * 255 * 2 + most) / (2 * most));
}

/// The colour that a pixel of so many bits can show. @param bits 1 to 24; below 4 they are greys
constexpr Srgb8 with_bit_depth(Srgb8 colour, int bits) {
  if (bits < 4) {
    const int luma = (299 * colour.r + 587 * colour.g + 114 * colour.b + 500) / 1000;
    const std::uint8_t grey = nearest_level(luma, bits);
    return {grey, grey, grey, colour.a};
  }
  const ChannelBits share = channel_bits(bits);
  return {nearest_level(colour.r, share.red), nearest_level(colour.g, share.green),
          nearest_level(colour.b, share.blue), colour.a};
}

/// Bytes of a frame buffer whose rows begin with a byte of their own.
constexpr std::int64_t frame_buffer_bytes(int width, int height, int bits) {
  return (std::int64_t{width} * bits + 7) / 8 * height;
}

}  // namespace kinescope
