// Lays characters' coverage on a picture, in linear light.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// The coverage of one character, its corner given from the pen's whole pixel and the baseline.
class GlyphCoverage {
 public:
  /// Covered pixels of a row; long runs of wholly covered ones are apart from others.
  struct Run {
    std::int16_t x, y, length;
    bool whole;
  };

  GlyphCoverage() = default;
  /// @param pixels row by row from the top, 255 is covered
  GlyphCoverage(int left, int top, int width, std::vector<std::uint8_t> pixels);

  int left() const { return left_; }
  int top() const { return top_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::span<const Run> runs() const { return runs_; }
  const std::uint8_t* at(int x, int y) const { return pixels_.data() + y * width_ + x; }

 private:
  int left_ = 0, top_ = 0, width_ = 0, height_ = 0;
  std::vector<std::uint8_t> pixels_;
  std::vector<Run> runs_;
};

/// The same as blend() of each pixel, sooner: text stands on an even ground nearly everywhere, so
/// what each of the 256 coverages makes of one ground is worked out once and looked up. Not for
/// several threads at once.
class GlyphPainter {
 public:
  GlyphPainter() : mixtures_(kMixtures) {}
  void draw(Image<Srgb8>& picture, const GlyphCoverage& glyph, int pen, int baseline, Srgb8 ink);
  /// Rows of a picture lie far apart: memory is asked for them before they are needed.
  static void ask_ahead(const Image<Srgb8>& picture, const GlyphCoverage& glyph, int pen,
                        int baseline);

 private:
  static constexpr std::size_t kMixtures = 16;
  struct Mixture {
    std::uint32_t ground = 0, ink = 0;  ///< four bytes each
    int met = 0;  ///< by how many characters, up to 2; the second pays for the table
    std::array<Srgb8, 256> mixed;
  };
  const Mixture* mixture(Srgb8 ground, Srgb8 ink);

  std::vector<Mixture> mixtures_;
};

}  // namespace kinescope
