// Areas: painted farthest first, with holes, bounded by curves, filled with a pattern.
#include "demos/lesson/lesson.h"
#include "raster/fill/pattern_fill.h"
#include "raster/fill/priority_fill.h"

namespace kinescope {
namespace {

enum { kKind };
enum { kPriority, kHole, kCurves, kPattern };

Contour box(glm::dvec2 centre, glm::dvec2 half) {
  return {centre - half,
          {centre.x + half.x, centre.y - half.y},
          centre + half,
          {centre.x - half.x, centre.y + half.y}};
}

class Areas : public ClonableDemo<Areas, Lesson> {
 public:
  explicit Areas(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Priority: what is nearest is painted last and stays. A hole turns "
                         "the other way. Curves become chords. Drag the areas.",
             .handles = {{"far", {0.35, 0.4}}, {"middle", {0.5, 0.55}}, {"near", {0.62, 0.45}}},
             .resolution = 3,
             .speed = 3},
            {choice_knob("area", {"1", "2", "3", "4"}, {"priority", "hole", "curves", "pattern"},
                         kPriority, "what is filled")}) {}

 private:
  /// Only those that the figure has.
  bool handle_in(int handle, int) const override {
    const int kind = knob(kKind).index();
    return kind == kHole ? handle > 0 : kind == kPattern ? handle == 1 : true;
  }

  Course record() const override {
    Track track(knob(kKind).text(), {"row", "from", "to", "area"});
    const auto row = [&](const RowSpan& span, double area, Srgb8 ink) {
      track.span(span, ink);
      track.step({double(span.y), double(span.x_begin), double(span.x_end), area});
    };
    const PixelRect window = world().window();
    const glm::dvec2 size(window.x1, window.y1);
    const Contour outer = box(corner(1), size * 0.28);
    switch (knob(kKind).index()) {
      case kPriority: {
        constexpr std::array kInks = {theme::kBlue, theme::kGreen, theme::kAccent};
        std::vector<PriorityArea> areas;
        // Given nearest first: the order of painting is the distances'.
        for (int i = 2; i >= 0; --i) areas.push_back({{box(corner(i), size * 0.2)}, 3.0 - i});
        priority_fill(areas, window, [&](std::size_t i, const RowSpan& span) {
          row(span, double(2 - i), kInks[2 - i]);
        });
        break;
      }
      case kHole: {
        Contour hole = box(corner(2), size * 0.12);
        std::reverse(hole.begin(), hole.end());
        scanline_fill({outer, hole}, FillRule::kNonZero, window,
                      [&](const RowSpan& span) { row(span, 0, theme::kCool); });
        break;
      }
      case kCurves: {
        Path path;
        path.move_to(corner(0));
        path.cubic_to(corner(0) + glm::dvec2(0, -0.4) * size, corner(2), corner(2));
        path.quadratic_to(corner(1) + glm::dvec2(0, 0.5) * size, corner(0));
        scanline_fill(path, PixelsFromPath(1), 0.05f, FillRule::kNonZero, window,
                      [&](const RowSpan& span) { row(span, 0, theme::kAccent); });
        break;
      }
      default: {
        Image<Srgb8> tile(4, 4, theme::kBlue);
        for (int i = 0; i < 4; ++i) tile.at(i, i) = theme::kAccent;
        const TilePattern<Srgb8> pattern(tile);
        scanline_fill({outer}, FillRule::kNonZero, window, [&](const RowSpan& span) {
          const auto plot = [&](int x, int y, Srgb8 ink) { track.plot(x, y, ink); };
          PatternedSink sink(pattern, plot);
          sink(span);
          track.step({double(span.y), double(span.x_begin), double(span.x_end), 0});
        });
      }
    }
    Course course;
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo areas_demo() {
  return {"areas",
          "8 Filling, characters, sampling",
          "Priority fill, polygons with holes, curve-bounded regions and patterns",
          [](const DemoSetup& setup) { return std::make_unique<Areas>(setup); },
          1,
          "drag the areas",
          {"priority fill (farthest first)", "polygons with holes", "curve-bounded regions",
           "pattern fill"}};
}

}  // namespace kinescope
