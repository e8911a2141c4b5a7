// Characters as strokes, for terminals and plotters that draw their own. Data: Hershey's Roman
// simplex (display/data/fonts/README).
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "display/vector/input/drawing.h"

namespace kinescope {

/// A point of a character: x from its middle, y from the base line upwards, both in heights of a
/// capital.
struct GlyphPoint {
  glm::vec2 at{0};
  bool drawn = false;  ///< a stroke leads here from the point before
};

struct TerminalGlyph {
  std::vector<GlyphPoint> points;
  float width = 0;  ///< of the ink and the space beside it, in heights of a capital
};

/// The character's strokes; those from space to ~ have any.
const TerminalGlyph& stroke_glyph(unsigned char character);

/// Calls sink(from, to) for each stroke of a text. A character wider than its cell is narrowed.
template <typename Sink>
void for_each_text_stroke(const DrawnText& text, Sink&& sink) {
  const float cell = std::sqrt(text.advance.x * text.advance.x + text.advance.y * text.advance.y);
  if (!(cell > 0)) return;
  const float height = std::sqrt(text.up.x * text.up.x + text.up.y * text.up.y);
  glm::vec2 middle = text.place + 0.5f * text.advance;
  for (const char c : text.text) {
    const TerminalGlyph& glyph = stroke_glyph(static_cast<unsigned char>(c));
    const float wanted = height / cell;
    const float across = glyph.width * wanted > 1 ? 1 / glyph.width : wanted;
    glm::vec2 pen = middle;
    for (const GlyphPoint& point : glyph.points) {
      const glm::vec2 to = middle + point.at.x * across * text.advance + point.at.y * text.up;
      if (point.drawn) sink(pen, to);
      pen = to;
    }
    middle += text.advance;
  }
}

}  // namespace kinescope
