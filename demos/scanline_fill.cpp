// Polygons row by row, the active edge table beside them.
#include <fmt/format.h>

#include "demos/lesson/lesson.h"
#include "raster/fill/scanline_fill.h"

namespace kinescope {
namespace {

class ScanlineFillDemo : public ClonableDemo<ScanlineFillDemo, Lesson> {
 public:
  explicit ScanlineFillDemo(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "Edges join the active table at their first row and leave behind "
                                  "their last; pairs of them bound the runs. A corner counts once. "
                                  "Drag a corner.",
                      .handles = {{"a", {0.15, 0.15}},
                                  {"b", {0.5, 0.35}},
                                  {"c", {0.85, 0.1}},
                                  {"d", {0.75, 0.85}},
                                  {"e", {0.5, 0.6}},
                                  {"f", {0.2, 0.9}}},
                      .resolution = 2,
                      .speed = 2},
                     {choice_knob("rule", {"1", "2"}, {"winding", "even-odd"}, 0,
                                  "what counts as inside where edges cross")}) {}

 private:
  Course record() const override {
    Polygon polygon(1);
    Course course;
    for (std::size_t i = 0; i < 6; ++i) polygon[0].push_back(corner(static_cast<int>(i)));
    contour_edges(polygon[0], [&](glm::dvec2 a, glm::dvec2 b) { course.guides.push_back({a, b}); });
    ScanlineFill fill(world().window(),
                      knob(0).index() == 0 ? FillRule::kNonZero : FillRule::kEvenOdd);
    fill.add(polygon);
    Track track("active edges", {"row", "edges", "waiting"});
    while (fill.next()) {
      std::string note = "edge  column   last  way\n";
      for (std::size_t i = 0; i < fill.active_count(); ++i) {
        const ActiveEdge& e = fill.active(i);
        note += fmt::format("{:>4}  {:>6} {:>6} {:>4}\n",
                            std::string(1, static_cast<char>('a' + e.edge % 26)), e.column,
                            e.y_end - 1, e.direction > 0 ? "down" : "up");
      }
      for (const RowSpan& span : fill.spans()) track(span);
      track.step({double(fill.y()), double(fill.active_count()), double(fill.waiting())},
                 std::move(note));
    }
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo scanline_fill_demo() {
  return {"scanline-fill",
          "8 Filling, characters, sampling",
          "A polygon row by row, with its active edge table",
          [](const DemoSetup& setup) { return std::make_unique<ScanlineFillDemo>(setup); },
          1,
          "drag a corner",
          {"scan-line fill with an active edge table", "vertices counted rightly"}};
}

}  // namespace kinescope
