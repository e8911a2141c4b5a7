// Two cubic pieces and their joint: derivatives and curvature on both sides of it, measured.
#include <fmt/format.h>

#include "demos/hodograph.h"
#include "demos/lesson/chart.h"
#include "engine/curves/continuity.h"

namespace kinescope {
namespace {

enum { kKeep, kComb };
enum { kFree, kKeepC0, kKeepG1, kKeepC1, kKeepC2 };
enum { kCurvePane, kFirstPane, kSecondPane, kCurvaturePane };

constexpr int kSteps = 60;  // a piece
using Points = std::vector<glm::dvec2>;

class ContinuityDemo : public ClonableDemo<ContinuityDemo, Lesson> {
 public:
  explicit ContinuityDemo(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "k keeps the joint C0, G1, C1 or C2. G1 turns no corner; C1 closes "
                         "the first derivative's gap; C2 the second's. Drag points.",
             .handles = {{"p0", {0.08, 0.75}},
                         {"p1", {0.12, 0.3}},
                         {"p2", {0.35, 0.15}},
                         {"p3", {0.5, 0.45}},
                         {"q3", {0.92, 0.3}},
                         {"q2", {0.85, 0.8}},
                         {"q1", {0.65, 0.85}},
                         {"q0", {0.55, 0.5}}},
             .figures = {{"G1 ratio", 0.5, 0.1, 3, 0.1}},
             .resolution = 7,
             .speed = 4},
            {choice_knob("keep", {"k"}, {"free", "C0", "G1", "C1", "C2"}, kKeepG1,
                         "what the second piece's first points obey"),
             toggle_knob("comb", "c", true, "curvature drawn across the curve")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }
  bool handle_in(int handle, int pane) const override {
    const int kept[] = {8, 7, 6, 6, 5};  // the points behind these follow from the first piece
    return pane == kCurvePane && handle < kept[knob(kKeep).index()];
  }

  /// The pieces, the second one's first points as the joint kept demands.
  std::array<Points, 2> pieces() const {
    for (int i = 0; i < 8; ++i) pixel(i);
    const Points p = {corner(0), corner(1), corner(2), corner(3)};
    Points q = {corner(7), corner(6), corner(5), corner(4)};
    const int keep = knob(kKeep).index();
    if (keep >= kKeepC0) q[0] = p[3];
    if (keep == kKeepG1) q[1] = p[3] + figure(0) * (p[3] - p[2]);
    if (keep >= kKeepC1) q[1] = 2.0 * p[3] - p[2];
    if (keep == kKeepC2) q[2] = p[1] + 2.0 * (q[1] - p[2]);
    return {p, q};
  }

  Track bend(Course& course, const std::array<Points, 2>& curves) const {
    Track track("curvature", {"u", "curvature"}, kCurvaturePane);
    const double most = 16.0 / world().columns();  // a circle of a pane's sixteenth
    const Chart chart(world(), {0, -most}, {2, most});
    chart.axes(course, kCurvaturePane, {1, 0});
    for (int piece = 0; piece < 2; ++piece) {
      const auto index = static_cast<std::size_t>(piece);
      InkPen pen(kChartInks[1 + index]);
      for (int i = 0; i <= kSteps; ++i) {
        const double t = double(i) / kSteps;
        const CurveEnd<glm::dvec2> at = bezier_at(std::span<const glm::dvec2>(curves[index]), t);
        // Seen with y upwards a turn to the left is positive.
        const double bent = -curvature(at);
        pen.to(track, world(), chart.place({piece + t, std::clamp(bent, -most, most)}));
        track.step({piece + t, bent});
        if (!knob(kComb).on() || i % 2 != 0) continue;
        const double speed = glm::length(at.first);
        if (!(speed > 0)) continue;
        const glm::dvec2 across = glm::dvec2(at.first.y, -at.first.x) / speed;
        const double tooth = std::clamp(bent / most, -1.0, 1.0) * 0.25 * world().rows();
        course.guides.push_back({at.point, at.point - tooth * across,
                                 theme::with_alpha(theme::kGreen, 150), kCurvePane});
      }
    }
    return track;
  }

  Course record() const override {
    const std::array<Points, 2> curve = pieces();
    std::array<Points, 2> first, second;
    Course course;
    for (std::size_t i = 0; i < 2; ++i) {
      first[i] = bezier_derivative(std::span<const glm::dvec2>(curve[i]));
      second[i] = bezier_derivative(std::span<const glm::dvec2>(first[i]));
      guide_chain(course, curve[i], theme::with_alpha(kChartInks[1 + i], 120), kCurvePane);
    }
    const PiecesPlan plan{world(), kSteps};
    course.tracks.push_back(pieces_track(plan, "curve", kCurvePane, curve));
    course.tracks.push_back(hodograph(plan, "first derivative", kFirstPane, first, course));
    course.tracks.push_back(hodograph(plan, "second derivative", kSecondPane, second, course));
    course.tracks.push_back(bend(course, curve));
    const auto before = bezier_end(std::span<const glm::dvec2>(curve[0]), true);
    const auto after = bezier_end(std::span<const glm::dvec2>(curve[1]), false);
    const auto joint = measure_joint(before, after);
    constexpr std::array kClasses = {"no continuity", "C0", "G1", "C1", "C2"};
    course.remarks = {
        fmt::format("the joint: {}", kClasses[static_cast<std::size_t>(joint.continuity)]),
        fmt::format("gap {:.2f} pixels", joint.gap),
        fmt::format("turn {:.2f} degrees", joint.turn_rad * 180 / std::acos(-1.0)),
        fmt::format("first derivative's step {:.2f}", joint.speed_step),
        fmt::format("second derivative's step {:.2f}", joint.second_step),
        fmt::format("curvature {:.4f} | {:.4f}", -curvature(before), -curvature(after))};
    return course;
  }
};

}  // namespace

DemoInfo continuity_demo() {
  return {"continuity",
          "9 Curves and fractals",
          "How two curves meet: C0, G1, C1 and C2, with derivatives and curvature measured",
          [](const DemoSetup& setup) { return std::make_unique<ContinuityDemo>(setup); },
          1,
          "drag the control points",
          {"continuity none, C0, C1, C2 and G1", "curvature"}};
}

}  // namespace kinescope
