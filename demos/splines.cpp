// Curves through points: Hermite's, cardinal (Catmull-Rom) and natural cubic splines of the same
// points, and blending functions beside them.
#include <fmt/format.h>

#include "demos/lesson/chart.h"
#include "engine/curves/continuity.h"
#include "engine/curves/interpolating.h"

namespace kinescope {
namespace {

enum { kTension, kBlending };
enum { kHermite, kCardinal, kNatural, kBezier, kBSpline };
enum { kHermitePane, kCardinalPane, kNaturalPane, kBlendingPane };

constexpr int kPoints = 5, kStepsAPiece = 40;
using Pieces = std::vector<CubicPiece<glm::dvec2>>;

class Splines : public ClonableDemo<Splines, Lesson> {
 public:
  explicit Splines(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Drag a point: cardinal splines change beside it only, the "
                         "natural one everywhere. Drag Hermite's slopes. 1 and 2: tension.",
             .handles = {{"p0", {0.1, 0.7}},
                         {"p1", {0.3, 0.2}},
                         {"p2", {0.5, 0.65}},
                         {"p3", {0.7, 0.3}},
                         {"p4", {0.9, 0.75}},
                         {"slope 0", {0.1, 0.4}, -1, 0},
                         {"slope 1", {0.43, 0.2}, -1, 1},
                         {"slope 2", {0.55, 0.9}, -1, 2},
                         {"slope 3", {0.7, 0.1}, -1, 3},
                         {"slope 4", {0.95, 0.95}, -1, 4}},
             .resolution = 7,
             .speed = 4},
            {number_knob("tension", "1", "2", -1, 1, 0.1, 0, "",
                         "of the cardinal spline; 0 is Catmull-Rom's"),
             choice_knob("blending", {"k"},
                         {"Hermite", "cardinal", "natural", "Bezier", "B-spline"}, kHermite,
                         "whose blending functions are drawn")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }
  bool handle_in(int handle, int pane) const override {
    return handle < kPoints ? pane != kBlendingPane : pane == kHermitePane;
  }

  Track curve(const char* name, const Pieces& pieces, int pane) const {
    Track track(name, {"u", "x", "y"}, pane);
    InkPen pen(theme::kText);
    for (int i = 0; i <= kStepsAPiece * static_cast<int>(pieces.size()); ++i) {
      const int piece = std::min(i / kStepsAPiece, static_cast<int>(pieces.size()) - 1);
      const double u = double(i) / kStepsAPiece;
      const glm::dvec2 p = bezier_point(
          std::span<const glm::dvec2>(pieces[static_cast<std::size_t>(piece)]), u - piece);
      pen.to(track, world(), p);
      track.step({u, p.x, p.y});
    }
    return track;
  }

  CubicWeights weights(double t) const {
    switch (knob(kBlending).index()) {
      case kHermite:
        return hermite_weights(t);
      case kCardinal:
        return catmull_rom_weights(t, knob(kTension).value);
      case kBezier:
        return cubic_bezier_weights(t);
      default:
        return cubic_b_spline_weights(t);
    }
  }

  /// Of one piece; the natural spline has no such: what a point of height 1 does to all of it.
  Track blending(Course& course) const {
    Track track(knob(kBlending).text() + " blending", {}, kBlendingPane);
    const bool natural = knob(kBlending).index() == kNatural;
    const Chart chart(world(), {0, -0.3}, {1, 1.1});
    chart.axes(course, kBlendingPane);
    const std::size_t count = natural ? kPoints : 4;
    std::vector<InkPen> pens = chart_pens(count);
    std::vector<std::vector<CubicPiece<glm::dvec2>>> unit(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<glm::dvec2> heights(kPoints, glm::dvec2(0));
      heights[i].x = 1;
      unit[i] = natural_cubic_pieces(std::span<const glm::dvec2>(heights));
    }
    constexpr int kSteps = kStepsAPiece * (kPoints - 1);
    for (int k = 0; k <= kSteps; ++k) {
      const double t = double(k) / kSteps;
      const CubicWeights four = weights(t);
      for (std::size_t i = 0; i < count; ++i) {
        const int piece = std::min(k / kStepsAPiece, kPoints - 2);
        const auto& control = unit[i][static_cast<std::size_t>(piece)];
        const double weight =
            natural
                ? bezier_point(std::span<const glm::dvec2>(control), t * (kPoints - 1) - piece).x
                : four[i];
        pens[i].to(track, world(), chart.place({t, weight}));
      }
      track.step({});
    }
    return track;
  }

  Course record() const override {
    std::vector<glm::dvec2> points, slopes;
    Course course;
    for (int i = 0; i < kPoints; ++i) {
      pixel(i), pixel(i + kPoints);
      points.push_back(corner(i));
      slopes.push_back(3.0 * (corner(i + kPoints) - corner(i)));  // its tip is a Bezier point
      course.guides.push_back({corner(i), corner(i + kPoints), theme::kGreen, kHermitePane});
    }
    constexpr std::array kNames = {"Hermite", "cardinal", "natural cubic"};
    constexpr std::array kClasses = {"none", "C0", "G1", "C1", "C2"};
    const std::span<const glm::dvec2> through(points);
    const std::array<Pieces, 3> all = {hermite_pieces(through, std::span<const glm::dvec2>(slopes)),
                                       catmull_rom_pieces(through, knob(kTension).value),
                                       natural_cubic_pieces(through)};
    for (std::size_t i = 0; i < all.size(); ++i) {
      course.tracks.push_back(curve(kNames[i], all[i], static_cast<int>(i)));
      course.remarks.push_back(fmt::format("{}: {} at every joint", kNames[i],
                                           kClasses[static_cast<std::size_t>(weakest_joint(
                                               std::span<const CubicPiece<glm::dvec2>>(all[i])))]));
    }
    course.tracks.push_back(blending(course));
    return course;
  }
};

}  // namespace

DemoInfo splines_demo() {
  return {"splines",
          "9 Curves and fractals",
          "Hermite, cardinal and natural cubic splines through the same points, side by side",
          [](const DemoSetup& setup) { return std::make_unique<Splines>(setup); },
          1,
          "drag points and slopes",
          {"Hermite", "Catmull-Rom", "natural cubic", "blending functions drawn",
           "interpolating and approximating splines", "piecewise and parametric curves"}};
}

}  // namespace kinescope
