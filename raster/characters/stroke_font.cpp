#include "raster/characters/stroke_font.h"

#include "hershey_roman_simplex.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// A coordinate is a printable character, counted from R.
int coordinate(char c) { return c - 'R'; }

/// The characters of a file without its line ends, which may stand anywhere in a long glyph.
class Columns {
 public:
  Columns(std::string_view text, const std::string& name) : name_(name) {
    for (const char c : text) {
      if (c != '\n' && c != '\r') characters_ += c;
    }
  }
  bool at_end() const { return at_ == characters_.size(); }
  std::string_view take(std::size_t count) {
    if (characters_.size() - at_ < count) fail("the glyph is cut off");
    at_ += count;
    return std::string_view(characters_).substr(at_ - count, count);
  }
  char take_coordinate() {
    const char c = take(1)[0];
    if (c < ' ' || c > '~') fail("not a coordinate");
    return c;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw_bad_input(what, name_, "character " + std::to_string(at_));
  }

 private:
  std::string characters_;
  std::size_t at_ = 0;
  const std::string& name_;
};

/// Three columns, right-aligned.
int take_count(Columns& columns) {
  int count = 0;
  for (const char c : columns.take(3)) {
    if (c == ' ') continue;
    if (c < '0' || c > '9') columns.fail("not a count of points");
    count = 10 * count + (c - '0');
  }
  if (count == 0) columns.fail("a glyph without its sides");
  return count;
}

StrokeGlyph read_glyph(Columns& columns) {
  columns.take(5);  // Hershey's number
  const int pairs = take_count(columns);
  StrokeGlyph glyph;
  glyph.left = coordinate(columns.take_coordinate());
  glyph.right = coordinate(columns.take_coordinate());
  bool lifted = true;
  for (int i = 1; i < pairs; ++i) {
    const char x = columns.take_coordinate(), y = columns.take_coordinate();
    if (x == ' ' && y == 'R') {
      lifted = true;
      continue;
    }
    if (lifted) glyph.polylines.emplace_back();
    lifted = false;
    glyph.polylines.back().push_back({coordinate(x), coordinate(y)});
  }
  return glyph;
}

}  // namespace

StrokeFont StrokeFont::parse_jhf(std::string_view text, const std::string& name) {
  StrokeFont font;
  Columns columns(text, name);
  while (!columns.at_end()) font.glyphs_.push_back(read_glyph(columns));
  if (font.glyphs_.empty()) throw_bad_input("the font has no characters", name);
  return font;
}

StrokeFont StrokeFont::roman_simplex() {
  return parse_jhf(embedded::hershey_roman_simplex(), "hershey_roman_simplex.jhf");
}

const StrokeGlyph* StrokeFont::glyph(char32_t code) const {
  constexpr char32_t kFirst = U' ';
  if (code >= kFirst && code - kFirst < glyphs_.size()) return &glyphs_[code - kFirst];
  return glyphs_.size() > U'?' - kFirst ? &glyphs_[U'?' - kFirst] : nullptr;
}

}  // namespace kinescope
