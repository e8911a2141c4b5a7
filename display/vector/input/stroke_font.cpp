#include "display/vector/input/stroke_font.h"

#include <array>
#include <charconv>
#include <string_view>

#include "hershey_roman_simplex_jhf.h"

namespace kinescope {
namespace {

// In the font's units, y downwards: base line, and a capital's top.
constexpr float kBase = 9, kCapital = 21;
constexpr int kFirst = ' ', kCount = 96;

/// One line: columns 5 to 7 count the pairs of letters that follow, each a place about 'R'. The
/// first pair is the left and right side; " R" lifts the pen.
TerminalGlyph parse_glyph(std::string_view line) {
  TerminalGlyph glyph;
  if (line.size() < 10) return glyph;
  const float left = static_cast<float>(line[8] - 'R'), right = static_cast<float>(line[9] - 'R');
  glyph.width = (right - left) / kCapital;
  bool drawn = false;
  for (std::size_t i = 10; i + 1 < line.size(); i += 2) {
    if (line[i] == ' ') {
      drawn = false;
      continue;
    }
    const float x = static_cast<float>(line[i] - 'R'), y = static_cast<float>(line[i + 1] - 'R');
    glyph.points.push_back(
        {{(x - 0.5f * (left + right)) / kCapital, (kBase - y) / kCapital}, drawn});
    drawn = true;
  }
  return glyph;
}

std::array<TerminalGlyph, kCount> parse_font(std::string_view text) {
  std::array<TerminalGlyph, kCount> font;
  for (TerminalGlyph& glyph : font) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    glyph = parse_glyph(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return font;
}

}  // namespace

const TerminalGlyph& stroke_glyph(unsigned char character) {
  static const std::array<TerminalGlyph, kCount> font =
      parse_font(embedded::hershey_roman_simplex_jhf());
  const bool known = character >= kFirst && character < kFirst + kCount;
  return font[known ? static_cast<std::size_t>(character - kFirst) : 0];
}

}  // namespace kinescope
