// Even-odd rule and winding number of a polygon that crosses itself, side by side.
#include <fmt/format.h>

#include <cmath>

#include "demos/lesson/lesson.h"
#include "raster/fill/inside_test.h"
#include "raster/fill/scanline_fill.h"

namespace kinescope {
namespace {

constexpr int kCorners = 5;  // the point that is tested is the handle behind them

class InsideTests : public ClonableDemo<InsideTests, Lesson> {
 public:
  explicit InsideTests(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "The star's middle: crossed twice, so even-odd leaves it out; wound "
                         "round twice, so the winding rule fills it. Drag the point or a "
                         "corner.",
             .handles = {{"a", {0.5, 0.1}},
                         {"b", {0.75, 0.85}},
                         {"c", {0.1, 0.38}},
                         {"d", {0.9, 0.38}},
                         {"e", {0.25, 0.85}},
                         {"point", {0.5, 0.5}}},
             .resolution = 3,
             .speed = 2},
            {toggle_knob("fill", "f", true, "every pixel by its rule, row by row")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  Course record() const override {
    Polygon polygon(1);
    Course course;
    for (int i = 0; i < kCorners; ++i) polygon[0].push_back(corner(i));
    contour_edges(polygon[0], [&](glm::dvec2 a, glm::dvec2 b) { course.guides.push_back({a, b}); });
    const glm::dvec2 point = corner(kCorners);
    course.guides.push_back({{0, point.y}, point, theme::kAccent});
    course.tracks.push_back(track("even-odd", polygon, point, FillRule::kEvenOdd));
    course.tracks.push_back(track("winding", polygon, point, FillRule::kNonZero));
    course.compare = knob(0).on();
    for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
      course.remarks.push_back(fmt::format("{}: the point is {}",
                                           rule == FillRule::kEvenOdd ? "even-odd" : "winding",
                                           is_inside(polygon, point, rule) ? "inside" : "outside"));
    }
    return course;
  }

  /// First the edges that the ray to the left may cross, then the rows.
  Track track(const char* name, const Polygon& polygon, glm::dvec2 point, FillRule rule) const {
    const bool even_odd = rule == FillRule::kEvenOdd;
    Track track(name, {"crossed", even_odd ? "count" : "winding", "pixels"}, even_odd ? 0 : 1);
    InsideTest test(polygon[0], point);
    while (test.next()) {
      track.plot(static_cast<int>(point.x), static_cast<int>(point.y), theme::kAccent);
      const int sum = even_odd ? test.crossings() : test.winding();
      track.step({double(test.direction()), double(sum), NAN});
    }
    if (!knob(0).on()) return track;
    fill(track, polygon, rule);
    return track;
  }

  /// A row a step, whether anything of it is inside or not, so that both rules keep step.
  void fill(Track& track, const Polygon& polygon, FillRule rule) const {
    std::vector<std::vector<RowSpan>> rows(static_cast<std::size_t>(world().rows()));
    scanline_fill(polygon, rule, world().window(), [&](const RowSpan& span) {
      rows[static_cast<std::size_t>(span.y)].push_back(span);
    });
    for (std::size_t y = 0; y < rows.size(); ++y) {
      double pixels = 0;
      for (const RowSpan& span : rows[y]) track(span), pixels += span.length();
      track.step({NAN, NAN, pixels}, fmt::format("row {}", y));
    }
  }
};

}  // namespace

DemoInfo inside_tests_demo() {
  return {"inside-tests",
          "8 Filling, characters, sampling",
          "Even-odd rule and winding number: a ray, its crossings, and where the two differ",
          [](const DemoSetup& setup) { return std::make_unique<InsideTests>(setup); },
          1,
          "drag the point or a corner",
          {"even-odd test", "winding-number test", "self-crossing polygons"}};
}

}  // namespace kinescope
