#include "raster/characters/bitmap_font.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>

#include "fixed_6x13.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// Lines of a BDF file, each a keyword and what follows it.
class BdfLines {
 public:
  BdfLines(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::size_t space = line.find(' ');
    keyword_ = line.substr(0, space);
    values_ = space == std::string_view::npos ? std::string_view() : line.substr(space + 1);
    ++number_;
    return true;
  }
  std::string_view keyword() const { return keyword_; }

  template <std::size_t kCount>
  std::array<int, kCount> integers() const {
    std::array<int, kCount> numbers{};
    std::string_view left = values_;
    for (int& number : numbers) {
      while (!left.empty() && left.front() == ' ') left.remove_prefix(1);
      const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), number);
      if (error != std::errc()) fail("a number is missing");
      left.remove_prefix(static_cast<std::size_t>(end - left.data()));
    }
    return numbers;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw_bad_input(what, name_, "line " + std::to_string(number_));
  }

 private:
  std::string_view rest_, keyword_, values_;
  const std::string& name_;
  int number_ = 0;
};

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

void read_row(const BdfLines& lines, int y, BitmapGlyph& glyph) {
  const std::string_view digits = lines.keyword();
  for (int x = 0; x < glyph.width; ++x) {
    const auto place = static_cast<std::size_t>(x / 4);
    const int digit = place < digits.size() ? hex_digit(digits[place]) : -1;
    if (digit < 0) lines.fail("a row of the bitmap is too short");
    glyph.pixels[static_cast<std::size_t>(y * glyph.width + x)] = digit >> (3 - x % 4) & 1;
  }
}

void read_box(const BdfLines& lines, BitmapGlyph& glyph) {
  const auto [width, height, left, bottom] = lines.integers<4>();
  constexpr int kMost = BitmapFont::kLargest;
  if (width < 0 || height < 0 || width > kMost || height > kMost || left < -kMost || left > kMost ||
      bottom < -kMost || bottom > kMost) {
    lines.fail("a character's box is out of bounds");
  }
  glyph.width = width;
  glyph.height = height;
  glyph.left = left;
  glyph.bottom = bottom;
}

/// One character, from the line after STARTCHAR to ENDCHAR; its code, negative if it has none.
int read_character(BdfLines& lines, BitmapGlyph& glyph) {
  int code = -1;
  while (lines.next()) {
    const std::string_view keyword = lines.keyword();
    if (keyword == "ENCODING") {
      code = lines.integers<1>()[0];
    } else if (keyword == "DWIDTH") {
      glyph.advance = lines.integers<1>()[0];
      if (std::abs(std::int64_t{glyph.advance}) > BitmapFont::kLargest) {
        lines.fail("a character's step is out of bounds");
      }
    } else if (keyword == "BBX") {
      read_box(lines, glyph);
    } else if (keyword == "BITMAP") {
      glyph.pixels.assign(static_cast<std::size_t>(glyph.width * glyph.height), false);
      for (int y = 0; y < glyph.height; ++y) {
        if (!lines.next()) lines.fail("the bitmap is cut off");
        read_row(lines, y, glyph);
      }
    } else if (keyword == "ENDCHAR") {
      if (glyph.pixels.size() != static_cast<std::size_t>(glyph.width * glyph.height)) {
        lines.fail("the character's box comes behind its bitmap, or it has none");
      }
      return code;
    }
  }
  lines.fail("the last character is cut off");
}

}  // namespace

BitmapFont BitmapFont::parse_bdf(std::string_view text, const std::string& name) {
  BitmapFont font;
  BdfLines lines(text, name);
  if (!lines.next() || lines.keyword() != "STARTFONT") lines.fail("not a BDF font");
  while (lines.next() && lines.keyword() != "ENDFONT") {
    const std::string_view keyword = lines.keyword();
    if (keyword == "FONT_ASCENT") {
      font.ascent_ = lines.integers<1>()[0];
    } else if (keyword == "FONT_DESCENT") {
      font.descent_ = lines.integers<1>()[0];
    } else if (keyword == "STARTCHAR") {
      BitmapGlyph glyph;
      const int code = read_character(lines, glyph);
      if (code >= 0) font.glyphs_.insert_or_assign(static_cast<char32_t>(code), std::move(glyph));
    }
  }
  if (font.glyphs_.empty()) throw_bad_input("the font has no characters", name);
  return font;
}

BitmapFont BitmapFont::fixed() { return parse_bdf(embedded::fixed_6x13(), "fixed_6x13.bdf"); }

const BitmapGlyph* BitmapFont::glyph(char32_t code) const {
  auto found = glyphs_.find(code);
  if (found == glyphs_.end()) found = glyphs_.find(U'?');
  return found == glyphs_.end() ? nullptr : &found->second;
}

}  // namespace kinescope
