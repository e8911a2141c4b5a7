// Fonts of bitmaps, read from BDF. Source: Adobe, "Glyph Bitmap Distribution Format", 2.2.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "raster/path/utf8.h"

namespace kinescope {

/// A glyph's box and its pixels, row by row from the top.
struct BitmapGlyph {
  int width = 0, height = 0;
  int left = 0, bottom = 0;  ///< of the box, from the pen on the baseline; y upwards
  int advance = 0;
  std::vector<bool> pixels;

  bool at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

class BitmapFont {
 public:
  /// Boxes and steps beyond this many pixels are refused.
  static constexpr int kLargest = 1024;

  /// @param name of the font, for messages. @throws Error (bad input)
  static BitmapFont parse_bdf(std::string_view text, const std::string& name);
  /// The X Window System's 6x13, linked in.
  static BitmapFont fixed();

  int ascent() const { return ascent_; }
  int descent() const { return descent_; }
  /// What stands for a character that the font lacks is its question mark, or nothing.
  const BitmapGlyph* glyph(char32_t code) const;

  /// Calls sink(x, y) for each pixel of a line of UTF-8 text, y downwards, from a pen on the
  /// baseline. @return the pen behind it
  template <typename Sink>
  glm::ivec2 draw(std::string_view text, glm::ivec2 pen, Sink&& sink) const {
    for_each_code_point(text, [&](char32_t code) {
      const BitmapGlyph* g = glyph(code);
      if (!g) return;
      const int top = pen.y - g->bottom - g->height;
      for (int y = 0; y < g->height; ++y) {
        for (int x = 0; x < g->width; ++x) {
          if (g->at(x, y)) sink(pen.x + g->left + x, top + y);
        }
      }
      pen.x += g->advance;
    });
    return pen;
  }

 private:
  int ascent_ = 0, descent_ = 0;
  std::map<char32_t, BitmapGlyph> glyphs_;
};

}  // namespace kinescope
