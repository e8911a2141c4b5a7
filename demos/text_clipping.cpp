// Text clipped to a window: all or none of the string, of each character, or piece by piece.
#include <fmt/format.h>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/clip/clip_text.h"
#include "raster/base/error.h"
#include "raster/characters/stroke_font.h"
#include "raster/fill/scanline_fill.h"
#include "raster/scan/limits.h"

namespace kinescope {
namespace {

enum { kWay, kFont };
enum { kLow, kHigh, kPen };
constexpr std::string_view kText = "Clip me";
constexpr float kChordTolerance = 0.1f;  // of an outline's curves, pixels

class TextCutter : public ClonableDemo<TextCutter, Lesson> {
 public:
  explicit TextCutter(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for =
                 "A string goes as a whole, or a character does, or each outline and stroke "
                 "is cut at the window. Red is thrown away. Drag the pen and the corners.",
             .handles = {{"corner", {0.18, 0.3}}, {"opposite", {0.82, 0.7}}, {"pen", {0.07, 0.58}}},
             .figures = {{"size", 34, 8, 80, 1}},
             .resolution = 6,
             .speed = 1},
            {choice_knob("way", {"1", "2", "3"}, {"string", "characters", "components"}, 2,
                         "what is kept or thrown away as a whole"),
             choice_knob("font", {"f"}, {"outline", "stroke"}, 0, "what characters are made of")}) {
  }

 private:
  ClipWindow window() const {
    check_coordinates(pixel(kLow));
    check_coordinates(pixel(kHigh));
    return {glm::min(corner(kLow), corner(kHigh)), glm::max(corner(kLow), corner(kHigh))};
  }

  PlacedGlyph outline(char letter, const glm::dvec2& pen, float size) const {
    const Font& font = studio().sans;
    const float scale = size / font.units_per_em();
    PlacedGlyph glyph;
    const glm::dvec2 end = pen + glm::dvec2(font.width_px({&letter, 1}, size), 0.25 * double(size));
    glyph.cell = {{pen.x, pen.y - double(font.ascent_px(size))}, end};
    glm::vec2 last{-1e9f};
    path_edges(font.outline(static_cast<char32_t>(letter)),
               PixelsFromPath({scale, 0}, {0, -scale}, glm::vec2(pen)), kChordTolerance,
               [&](glm::vec2 a, glm::vec2 b) {
                 if (a != last) glyph.outlines.emplace_back();
                 glyph.outlines.back().emplace_back(a);
                 last = b;
               });
    return glyph;
  }

  PlacedGlyph strokes(char letter, const glm::dvec2& pen, double size) const {
    const double scale = size / StrokeFont::kCapitalHeight;
    PlacedGlyph glyph;
    const glm::dvec2 end =
        StrokeFont::roman_simplex().draw({&letter, 1}, pen, scale, [&](glm::dvec2 a, glm::dvec2 b) {
          glyph.strokes.push_back({a, b});
        });
    glyph.cell = {{pen.x, pen.y - size}, {end.x, pen.y + size / 3}};
    return glyph;
  }

  std::vector<PlacedGlyph> string() const {
    const int size = whole_figure(0);
    if (size < 1 || size > 400) throw_bad_input("size: from 1 to 400 pixels");
    check_coordinates(pixel(kPen));
    glm::dvec2 pen = corner(kPen);
    std::vector<PlacedGlyph> string;
    for (const char letter : kText) {
      string.push_back(knob(kFont).index() == 0 ? outline(letter, pen, static_cast<float>(size))
                                                : strokes(letter, pen, size));
      pen.x = string.back().cell.max.x;
    }
    return string;
  }

  void ink(Track& track, const PlacedGlyph& glyph, Srgb8 colour) const {
    if (!glyph.outlines.empty()) {
      scanline_fill(glyph.outlines, FillRule::kNonZero, world().window(),
                    [&](const RowSpan& span) { track.span(span, colour); });
    }
    for (const Segment2& s : glyph.strokes) ink_line(track, world(), s.from, s.to, colour);
  }

  Course record() const override {
    const ClipWindow window = this->window();
    const auto way = static_cast<TextClipping>(knob(kWay).index());
    const std::vector<PlacedGlyph> string = this->string();
    std::vector<PlacedGlyph> kept;
    clip_text(window, string, way, [&](const PlacedGlyph& glyph) { kept.push_back(glyph); });
    Track track("text", {"from x", "to x", "pieces"});
    std::size_t next = 0;
    for (std::size_t i = 0; i < string.size(); ++i) {
      const PlacedGlyph& whole = string[i];
      const bool left = next < kept.size() && kept[next].cell.min == whole.cell.min &&
                        kept[next].cell.max == whole.cell.max;
      ink(track, whole, theme::kRed);
      std::size_t pieces = 0;
      if (left) {
        ink(track, kept[next], theme::kText);
        pieces = kept[next].outlines.size() + kept[next].strokes.size();
        ++next;
      }
      track.step({whole.cell.min.x, whole.cell.max.x, double(pieces)},
                 fmt::format("'{}': its cell is {}\n", kText[i],
                             holds(window, whole.cell) ? "inside" : "not all inside"));
    }
    Course course;
    course.tracks.push_back(std::move(track));
    const auto box = [&](const ClipWindow& w, Srgb8 colour) {
      const std::array<glm::dvec2, 4> c = {w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}};
      for (std::size_t i = 0; i < 4; ++i) course.guides.push_back({c[i], c[(i + 1) % 4], colour});
    };
    for (const PlacedGlyph& glyph : string) box(glyph.cell, theme::kKeyCap);
    box(window, theme::kCool);
    course.remarks.push_back(
        fmt::format("{} of {} characters are left", kept.size(), string.size()));
    return course;
  }
};

}  // namespace

DemoInfo text_clipping_demo() {
  return {"text-clipping",
          "7 Viewing and clipping",
          "Text clipped by the whole string, by characters, and by outlines and strokes",
          [](const DemoSetup& setup) { return std::make_unique<TextCutter>(setup); },
          1,
          "drag pen and corners",
          {"text: all-or-none string", "all-or-none character", "text by component"}};
}

}  // namespace kinescope
