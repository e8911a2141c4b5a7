// Characters as bitmaps, as strokes, and as outlines scan-converted in four steps.
#include <fmt/format.h>

#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/characters/bitmap_font.h"
#include "raster/characters/glyph_scan.h"
#include "raster/characters/stroke_font.h"
#include "raster/path/utf8.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {
namespace {

enum { kKind };
enum { kBitmap, kStroke, kOutline };

class Characters : public ClonableDemo<Characters, Lesson> {
 public:
  explicit Characters(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "An outline is scaled, fitted to the grid, filled, and mended where "
                         "a thin part fell between pixels' middles (red). Make it small; click the "
                         "field \"text\" and type.",
             .handles = {{"pen", {0.25, 0.75}}},
             .figures = {{"size", 24, 4, 60, 1}},
             .words = Words{"text", "g"},
             .resolution = 2,
             .speed = 1},
            {choice_knob("font", {"1", "2", "3"}, {"bitmap", "stroke", "outline"}, kOutline,
                         "what the characters are made of")}) {}

 private:
  Course record() const override {
    const int size = whole_figure(0);
    if (size < 1 || size > 400) throw_bad_input("size: from 1 to 400 pixels");
    if (words().empty()) throw_bad_input("there is no text: type some");
    switch (knob(kKind).index()) {
      case kBitmap:
        return bitmap();
      case kStroke:
        return strokes(size);
      default:
        return outline(size);
    }
  }

  /// Says how many of the characters are not those that were typed.
  template <typename Missing>
  void tell_missing(Course& course, Missing&& is_missing) const {
    int missing = 0;
    for_each_code_point(words(), [&](char32_t code) { missing += is_missing(code) ? 1 : 0; });
    if (missing > 0) {
      course.remarks.push_back(
          fmt::format("The font lacks {} of the characters: marks stand "
                      "for them.",
                      missing));
    }
  }

  Course bitmap() const {
    Track track("bitmap 6x13", {"x", "y"});
    const BitmapFont font = BitmapFont::fixed();
    font.draw(words(), pixel(0), [&](int x, int y) {
      track(x, y);
      track.step({double(x), double(y)});
    });
    Course course;
    tell_missing(course,
                 [&](char32_t c) { return c != U'?' && font.glyph(c) == font.glyph(U'?'); });
    course.tracks.push_back(std::move(track));
    return course;
  }

  Course strokes(int size) const {
    Track track("Hershey strokes", {"from x", "y", "to x", "y"});
    Course course;
    const double scale = double(size) / StrokeFont::kEm;
    const StrokeFont font = StrokeFont::roman_simplex();
    font.draw(words(), corner(0), scale, [&](glm::dvec2 a, glm::dvec2 b) {
      for (BresenhamSteps line(glm::ivec2(glm::floor(a)), glm::ivec2(glm::floor(b)));
           line.next();) {
        track(line.at().x, line.at().y);
      }
      track.step({a.x, a.y, b.x, b.y});
      course.guides.push_back({a, b});
    });
    tell_missing(course,
                 [&](char32_t c) { return c != U'?' && font.glyph(c) == font.glyph(U'?'); });
    course.tracks.push_back(std::move(track));
    return course;
  }

  Course outline(int size) const {
    const Path path = studio().sans.line_outline(words());
    const float scale = static_cast<float>(size) / studio().sans.units_per_em();
    const glm::vec2 pen = corner(0) - 0.5;
    const PixelsFromPath place({scale, 0}, {0, -scale}, pen);
    const World world = this->world();
    GlyphScan scan(path, place, world.columns(), world.rows());
    Track track("scan conversion", {"pixels"});
    Course course;
    while (scan.next()) {
      double count = 0;
      for (int y = 0; y < world.rows(); ++y) {
        for (int x = 0; x < world.columns(); ++x) {
          const GlyphPixel pixel =
              scan.pixels().empty() ? GlyphPixel::kOff : scan.pixels().at(x, y);
          if (pixel == GlyphPixel::kOff) continue;
          track.plot(x, y, pixel == GlyphPixel::kInside ? theme::kText : theme::kRed);
          ++count;
        }
      }
      constexpr std::array kNames = {"", "scaled to the grid", "fitted to it", "filled", "mended"};
      track.step({count}, kNames[static_cast<std::size_t>(scan.step())]);
    }
    path_edges(scan.outline(), PixelsFromPath(1), 0.05f, [&](glm::vec2 a, glm::vec2 b) {
      course.guides.push_back({a, b});
    });
    const std::vector<glm::vec2> mark = studio().sans.outline(0x10ffff).points;
    tell_missing(course, [&](char32_t c) { return studio().sans.outline(c).points == mark; });
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo characters_demo() {
  return {
      "characters",
      "8 Filling, characters, sampling",
      "Bitmap, stroke and outline characters; scan conversion in four steps with dropout control",
      [](const DemoSetup& setup) { return std::make_unique<Characters>(setup); },
      1,
      "drag the pen",
      {"bitmap fonts", "stroke fonts", "outline fonts in four steps with dropout control"}};
}

}  // namespace kinescope
