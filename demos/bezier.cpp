// Bezier curves: de Casteljau's ladder at one parameter, and the curve that its last rung draws.
#include <fmt/format.h>

#include <array>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/curves/bezier.h"
#include "engine/curves/convex_hull.h"

namespace kinescope {
namespace {

enum { kParameter, kHull };

constexpr int kSteps = 200;

class Bezier : public ClonableDemo<Bezier, Lesson> {
 public:
  explicit Bezier(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "Each rung divides the legs of the one above in the same share; "
                                  "the last point is the curve's. Drag points; 1 and 2 move t.",
                      .handles = {{"p0", {0.1, 0.8}},
                                  {"p1", {0.2, 0.15}},
                                  {"p2", {0.75, 0.1}},
                                  {"p3", {0.9, 0.75}}},
                      .resolution = 4,
                      .speed = 4},
                     {number_knob("t", "1", "2", 0, 1, 0.05, 0.4, "", "of the ladder shown"),
                      toggle_knob("hull", "h", false, "the points' convex hull holds the curve")}) {
  }

 private:
  Course record() const override {
    std::vector<glm::dvec2> control;
    for (int i = 0; i < 4; ++i) pixel(i), control.push_back(corner(i));
    const std::span<const glm::dvec2> points(control);
    Course course;
    Track track("de Casteljau", {"t", "x", "y"});
    const World pane = world();
    for (int i = 0; i <= kSteps; ++i) {
      const double t = double(i) / kSteps;
      const glm::dvec2 p = bezier_point(points, t);
      ink_point(track, pane, p);
      track.step({t, p.x, p.y});
    }
    course.tracks.push_back(std::move(track));
    constexpr std::array kInks = {theme::kCool, theme::kAccent, theme::kGreen, theme::kRed};
    DeCasteljau<glm::dvec2> ladder(points, knob(kParameter).value);
    while (ladder.next()) {
    }
    for (std::size_t r = 0; r < ladder.rungs().size(); ++r) {
      const auto& rung = ladder.rungs()[r];
      for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
        course.guides.push_back({rung[i], rung[i + 1], kInks[r % kInks.size()]});
      }
    }
    const glm::dvec2 at = ladder.rungs().back()[0];
    course.remarks.push_back(
        fmt::format("at t = {:.2f}: ({:.2f}, {:.2f})", ladder.t(), at.x, at.y));
    const std::vector<double> weight = bernstein(3, ladder.t());
    course.remarks.push_back(fmt::format("weights {:.3f} {:.3f} {:.3f} {:.3f}", weight[0],
                                         weight[1], weight[2], weight[3]));
    if (knob(kHull).on()) {
      const auto hull = convex_hull(points);
      for (std::size_t i = 0; i < hull.size(); ++i) {
        course.guides.push_back({hull[i], hull[(i + 1) % hull.size()], theme::kDim});
      }
    }
    return course;
  }
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Bezier>(setup); }

}  // namespace

DemoInfo bezier_demo() {
  return {"bezier",
          "9 Curves and fractals",
          "A Bezier curve by de Casteljau's ladder, its control points dragged",
          create,
          1,
          "drag a control point",
          {"Bezier (de Casteljau, Bernstein)", "convex hull"}};
}

}  // namespace kinescope
