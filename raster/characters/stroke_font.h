// Fonts of strokes: the Hershey fonts, read from Hurt's format.
// Source: A. V. Hershey, "Calligraphy for computers", 1967.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "raster/path/utf8.h"

namespace kinescope {

/// A character as straight strokes in Hershey's units: x from the character's middle, y downwards
/// from the middle of its capitals, whose baseline lies at 9.
struct StrokeGlyph {
  int left = 0, right = 0;                         ///< its sides
  std::vector<std::vector<glm::ivec2>> polylines;  ///< without the pen being lifted
};

class StrokeFont {
 public:
  static constexpr int kBaseline = 9;
  static constexpr int kCapitalHeight = 21;
  static constexpr int kEm = 32;  ///< from the tops of brackets to the deepest descenders

  /// Glyphs in order are characters 32 and on. @param name of the font, for messages.
  /// @throws Error (bad input)
  static StrokeFont parse_jhf(std::string_view text, const std::string& name);
  /// Roman Simplex, linked in.
  static StrokeFont roman_simplex();

  std::size_t size() const { return glyphs_.size(); }
  /// What stands for a character that the font lacks is its question mark, or nothing.
  const StrokeGlyph* glyph(char32_t code) const;

  /// Calls sink(from, to) for each stroke of a line of UTF-8 text from a pen on the baseline, y
  /// downwards; a unit of the font is `scale` long. @return the pen behind it
  template <typename Sink>
  glm::dvec2 draw(std::string_view text, glm::dvec2 pen, double scale, Sink&& sink) const {
    for_each_code_point(text, [&](char32_t code) {
      const StrokeGlyph* g = glyph(code);
      if (!g) return;
      const auto at = [&](glm::ivec2 p) {
        return pen + scale * glm::dvec2(p.x - g->left, p.y - kBaseline);
      };
      for (const std::vector<glm::ivec2>& line : g->polylines) {
        if (line.size() == 1) sink(at(line[0]), at(line[0]));
        for (std::size_t i = 1; i < line.size(); ++i) sink(at(line[i - 1]), at(line[i]));
      }
      pen.x += scale * (g->right - g->left);
    });
    return pen;
  }

 private:
  std::vector<StrokeGlyph> glyphs_;
};

}  // namespace kinescope
