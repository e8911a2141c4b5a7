// B-splines of any order beside the Bezier curve of the same points, and cut into Bezier pieces.
#include <fmt/format.h>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/curves/b_spline.h"
#include "engine/curves/bezier.h"

namespace kinescope {
namespace {

enum { kOrder, kKnots, kPieces, kLadder, kParameter };

constexpr int kSteps = 300, kControls = 6;

class BSplines : public ClonableDemo<BSplines, Lesson> {
 public:
  explicit BSplines(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Drag a point: the B-spline (white) changes only near it, the "
                         "Bezier curve (amber) everywhere. 1 and 2 change the order; "
                         "k: given knots, to be typed; l: de Casteljau's ladder.",
             .handles = {{"p0", {0.1, 0.8}},
                         {"p1", {0.15, 0.2}},
                         {"p2", {0.4, 0.15}},
                         {"p3", {0.55, 0.85}},
                         {"p4", {0.8, 0.8}},
                         {"p5", {0.9, 0.2}}},
             .words = Words{"given knots", "0 0 0 0 1 1 4 4 4 4"},
             .resolution = 4,
             .speed = 4},
            {number_knob("order", "1", "2", 2, kControls, 1, 4, "", "degree and one"),
             choice_knob("knots", {"k"}, {"open", "uniform", "given"}, 0,
                         "ends repeated until the curve reaches them, or not, or as typed"),
             toggle_knob("pieces", "p", false, "the Bezier points of each piece"),
             toggle_knob("ladder", "l", false, "de Casteljau's, of the Bezier curve"),
             number_knob("t", "3", "4", 0, 1, 0.05, 0.4, "", "of the ladder")}) {}

 private:
  std::vector<double> knots(int order) const {
    constexpr int kOpen = 0, kUniform = 1;
    if (knob(kKnots).index() == kOpen) return open_knots(order, kControls);
    if (knob(kKnots).index() == kUniform) return uniform_knots(order, kControls);
    return typed_numbers(words(), static_cast<std::size_t>(order + kControls));
  }

  Course record() const override {
    BSpline<glm::dvec2> spline;
    spline.order = knob(kOrder).index();
    for (int i = 0; i < kControls; ++i) pixel(i), spline.control.push_back(corner(i));
    spline.knots = knots(spline.order);
    check_knots(spline.order, kControls, spline.knots);
    const World pane = world();
    Course course;
    Track track("B-spline", {"t", "x", "y"}), bezier("Bezier", {"t", "x", "y"}, 0, theme::kAccent);
    for (int i = 0; i <= kSteps; ++i) {
      const double share = double(i) / kSteps;
      const double t = spline.first() + share * (spline.last() - spline.first());
      const glm::dvec2 p = b_spline_point(spline, t);
      ink_point(track, pane, p);
      track.step({t, p.x, p.y});
      const glm::dvec2 q = bezier_point(std::span<const glm::dvec2>(spline.control), share);
      ink_point(bezier, pane, q, theme::kAccent);
      bezier.step({share, q.x, q.y});
    }
    course.tracks.push_back(std::move(track));
    course.tracks.push_back(std::move(bezier));
    const auto chain = [&](const std::vector<glm::dvec2>& points, Srgb8 colour) {
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        course.guides.push_back({points[i], points[i + 1], colour});
      }
    };
    chain(spline.control, theme::kCool);
    const auto pieces = bezier_pieces(spline);
    if (knob(kPieces).on()) {
      for (const auto& piece : pieces) chain(piece.control, theme::kGreen);
    }
    if (knob(kLadder).on()) {
      DeCasteljau<glm::dvec2> ladder(spline.control, knob(kParameter).value);
      while (ladder.next()) chain(ladder.rungs().back(), theme::kRed);
      const glm::dvec2 at = ladder.rungs().back()[0];
      course.remarks.push_back(
          fmt::format("Bezier at t = {:.2f}: ({:.2f}, {:.2f})", ladder.t(), at.x, at.y));
    }
    course.remarks.push_back(
        fmt::format("{} Bezier pieces of degree {}", pieces.size(), spline.order - 1));
    std::string knots = "knots";
    for (const double k : spline.knots) knots += fmt::format(" {:.3g}", k);
    course.remarks.push_back(knots);
    return course;
  }
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<BSplines>(setup); }

}  // namespace

DemoInfo b_splines_demo() {
  return {"b-splines",
          "9 Curves and fractals",
          "B-splines of any order and knots, beside the Bezier curve of the same points",
          create,
          1,
          "drag a control point",
          {"B-splines of any order", "uniform, open and given knots", "cut into its Bezier pieces",
           "beside a Bezier curve of the same points", "local against global control"}};
}

DemoInfo practical_10_demo() {
  DemoInfo info = b_splines_demo();
  info.name = "practical-10";
  info.chapter = "Practicals";
  info.summary = "Practical 10: Bezier and B-spline curves, their control points dragged";
  info.topics = {"practical 10"};
  return info;
}

}  // namespace kinescope
