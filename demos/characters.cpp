// Characters as bitmaps, as strokes, and as outlines scan-converted in four steps.
#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/characters/bitmap_font.h"
#include "raster/characters/glyph_scan.h"
#include "raster/characters/stroke_font.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {
namespace {

enum { kKind, kLetter };
enum { kBitmap, kStroke, kOutline };
constexpr std::array kLetters = {"A", "g", "R", "8"};

class Characters : public ClonableDemo<Characters, Lesson> {
 public:
  explicit Characters(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "An outline is scaled, fitted to the grid, filled, and mended where "
                         "a thin part fell between pixels' middles (red). Make it small.",
             .handles = {{"pen", {0.25, 0.75}}},
             .figures = {{"size", 24, 4, 60, 1}},
             .resolution = 2,
             .speed = 1},
            {choice_knob("font", {"1", "2", "3"}, {"bitmap", "stroke", "outline"}, kOutline,
                         "what the character is made of"),
             choice_knob("letter", {"l"}, {"A", "g", "R", "8"}, 1, "which character")}) {}

 private:
  Course record() const override {
    const int size = whole_figure(0);
    if (size < 1 || size > 400) throw_bad_input("size: from 1 to 400 pixels");
    const char* letter = kLetters[static_cast<std::size_t>(knob(kLetter).index())];
    switch (knob(kKind).index()) {
      case kBitmap:
        return bitmap(letter);
      case kStroke:
        return strokes(letter, size);
      default:
        return outline(letter, size);
    }
  }

  Course bitmap(const char* letter) const {
    Track track("bitmap 6x13", {"x", "y"});
    BitmapFont::fixed().draw(letter, pixel(0), [&](int x, int y) {
      track(x, y);
      track.step({double(x), double(y)});
    });
    Course course;
    course.tracks.push_back(std::move(track));
    return course;
  }

  Course strokes(const char* letter, int size) const {
    Track track("Hershey strokes", {"from x", "y", "to x", "y"});
    Course course;
    const double scale = double(size) / StrokeFont::kCapitalHeight;
    StrokeFont::roman_simplex().draw(letter, corner(0), scale, [&](glm::dvec2 a, glm::dvec2 b) {
      for (BresenhamSteps line(glm::ivec2(glm::floor(a)), glm::ivec2(glm::floor(b)));
           line.next();) {
        track(line.at().x, line.at().y);
      }
      track.step({a.x, a.y, b.x, b.y});
      course.guides.push_back({a, b});
    });
    course.tracks.push_back(std::move(track));
    return course;
  }

  Course outline(const char* letter, int size) const {
    const Path path = studio().sans.outline(static_cast<char32_t>(letter[0]));
    const float scale = static_cast<float>(size) / studio().sans.units_per_em();
    const glm::vec2 pen = corner(0) - 0.5;
    const PixelsFromPath place({scale, 0}, {0, -scale}, pen);
    const World world = this->world();
    GlyphScan scan(path, place, world.columns(), world.rows());
    Track track("scan conversion", {"step", "pixels"});
    Course course;
    for (double step = 1; scan.next(); ++step) {
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
      track.step({step, count}, kNames[static_cast<std::size_t>(scan.step())]);
    }
    path_edges(scan.outline(), PixelsFromPath(1), 0.05f, [&](glm::vec2 a, glm::vec2 b) {
      course.guides.push_back({a, b});
    });
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
