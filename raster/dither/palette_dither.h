// Pictures of a palette: the nearest entry, or the nearest with its error diffused.
// Source: R. W. Floyd and L. Steinberg, 1976, on three channels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/dither/median_cut.h"

namespace kinescope {

/// Finds the nearest entry by squared distance, of equals the first. Remembers what it found.
class NearestEntry {
 public:
  /// @throws Error (usage) unless the palette has 1 to 256 entries
  explicit NearestEntry(const Palette& palette);
  std::uint8_t operator()(int r, int g, int b);

 private:
  struct Found {
    std::uint32_t colour = 0xffffffffu;
    std::uint8_t entry = 0;
  };
  const Palette& palette_;
  std::vector<Found> found_;
};

/// Each pixel's nearest entry.
Image<std::uint8_t> to_palette(const Image<Srgb8>& image, const Palette& palette);

/// Floyd-Steinberg, every other row backwards; errors in 1/16 code.
Image<std::uint8_t> diffuse_to_palette(const Image<Srgb8>& image, const Palette& palette);

}  // namespace kinescope
