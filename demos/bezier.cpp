// Bezier curves: de Casteljau's ladder at one parameter, and the curve that its last rung draws.
#include <fmt/format.h>

#include <array>

#include "demos/lesson/chart.h"
#include "engine/curves/bezier.h"
#include "engine/curves/convex_hull.h"

namespace kinescope {
namespace {

enum { kParameter, kPoints, kHull, kCut };

constexpr int kSteps = 200;

class Bezier : public ClonableDemo<Bezier, Lesson> {
 public:
  explicit Bezier(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each rung divides the legs of the one above in the same share; the "
                         "last point is the curve's. 1, 2 move t; c cuts the curve there.",
             .handles = {{"p0", {0.1, 0.8}},
                         {"p1", {0.2, 0.15}},
                         {"p2", {0.75, 0.1}},
                         {"p3", {0.9, 0.75}},
                         {"p4", {0.6, 0.9}},
                         {"p5", {0.4, 0.6}}},
             .resolution = 4,
             .speed = 4},
            {number_knob("t", "1", "2", 0, 1, 0.05, 0.4, "", "of the ladder shown"),
             number_knob("points", "3", "4", 2, 6, 1, 4, "", "one more than the degree"),
             toggle_knob("hull", "h", false, "the points' convex hull holds the curve"),
             toggle_knob("cut", "c", false, "two curves of the same degree: the ladder's sides")}) {
  }

 private:
  bool handle_in(int handle, int) const override { return handle < knob(kPoints).index(); }

  Course record() const override {
    std::vector<glm::dvec2> control;
    for (int i = 0; i < knob(kPoints).index(); ++i) pixel(i), control.push_back(corner(i));
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
    constexpr std::array kInks = {theme::kCool, theme::kAccent, theme::kGreen,
                                  theme::kRed,  theme::kBlue,   theme::kText};
    DeCasteljau<glm::dvec2> ladder(points, knob(kParameter).value);
    while (ladder.next()) {
    }
    if (knob(kCut).on()) {
      const auto halves = bezier_split(points, ladder.t());
      guide_chain(course, halves.before, theme::kGreen);
      guide_chain(course, halves.after, theme::kRed);
    } else {
      for (std::size_t r = 0; r < ladder.rungs().size(); ++r) {
        guide_chain(course, ladder.rungs()[r], kInks[r]);
      }
    }
    const glm::dvec2 at = ladder.rungs().back()[0];
    course.remarks.push_back(
        fmt::format("at t = {:.2f}: ({:.2f}, {:.2f})", ladder.t(), at.x, at.y));
    std::string weights = "weights";
    for (const double w : bernstein(static_cast<int>(points.size()) - 1, ladder.t())) {
      weights += fmt::format(" {:.3f}", w);
    }
    course.remarks.push_back(weights);
    if (knob(kHull).on()) {
      std::vector<glm::dvec2> hull = convex_hull(points);
      hull.push_back(hull.front());
      guide_chain(course, hull, theme::kDim);
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
          {"Bezier of any degree (de Casteljau, Bernstein, subdivision)", "convex hull"}};
}

}  // namespace kinescope
