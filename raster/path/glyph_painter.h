// Lays characters' coverage on a picture, in linear light.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// The coverage of one character, its corner given from the pen's whole pixel and the baseline.
struct GlyphCoverage {
  int left = 0, top = 0;
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< row by row from the top, 255 is covered
};

/// The same as blend() of each pixel, sooner: text stands on an even ground nearly everywhere, so
/// what each of the 256 coverages makes of one ground is worked out once and looked up. Not for
/// several threads at once.
class GlyphPainter {
 public:
  GlyphPainter() : mixtures_(kMixtures) {}
  void draw(Image<Srgb8>& picture, const GlyphCoverage& glyph, int pen, int baseline, Srgb8 ink);

 private:
  static constexpr std::size_t kMixtures = 16;
  struct Mixture {
    Srgb8 ground{}, ink{};
    int met = 0;  ///< by how many characters, up to 2; the second pays for the table
    std::array<Srgb8, 256> mixed;
  };
  const Mixture* mixture(Srgb8 ground, Srgb8 ink);

  std::vector<Mixture> mixtures_;
};

}  // namespace kinescope
