// Encoded pixels packed into words of 32 bits, in the order that a window or a frame buffer has.
#pragma once

#include <cstdint>
#include <span>

#include "raster/colour/colour.h"

namespace kinescope {

/// Where each channel's eight bits begin in a word; the other bits are 0.
struct WordLayout {
  int r_shift = 16, g_shift = 8, b_shift = 0;
};

/// Writes in.size() words; `out` is at least as long.
void pack_words(std::span<const Srgb8> in, WordLayout layout, std::span<std::uint32_t> out);

}  // namespace kinescope
