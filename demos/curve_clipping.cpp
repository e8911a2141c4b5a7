// Curves clipped to a window: first by the box that bounds them, then exactly.
#include <fmt/format.h>

#include <numbers>

#include "demos/lesson/chart.h"
#include "engine/clip/clip_curve.h"
#include "engine/clip/outcode.h"
#include "engine/curves/bezier.h"
#include "raster/scan/limits.h"

namespace kinescope {
namespace {

enum { kCurve };
enum { kEllipse, kBezier };
enum { kLow, kHigh, kA, kB, kC, kD };
constexpr int kPieces = 120;  // chords of a curve, one a step

class CurveClipping : public ClonableDemo<CurveClipping, Lesson> {
 public:
  explicit CurveClipping(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "The box about a curve (dim) settles it where it lies all inside or "
                         "beyond one side; else the crossings are solved for. Red is thrown away. "
                         "Drag: an ellipse is a centre and a corner of its box.",
             .handles = {{"corner", {0.3, 0.75}},
                         {"opposite", {0.75, 0.25}},
                         {"a", {0.32, 0.4}},
                         {"b", {0.46, 0.75}},
                         {"c", {0.78, 0.2}},
                         {"d", {0.92, 0.4}}},
             .resolution = 6,
             .speed = 4,
             .centred = true},
            {choice_knob("curve", {"1", "2"}, {"two ellipses", "Bezier"}, 0, "what is clipped")}) {}

 private:
  ClipWindow between(int i, int j) const {
    check_coordinates(pixel(i));
    check_coordinates(pixel(j));
    return ClipWindow::between(named_point(i), named_point(j));
  }

  void add_box(Course& course, const ClipWindow& box, Srgb8 colour) const {
    guide_rectangle(course, world().middle_of(box.min), world().middle_of(box.max), colour);
  }

  /// A curve in chords: white where a part holds their middles, red elsewhere.
  template <typename Point>
  void walk(Track& track, const ClipWindow& box, const ClipWindow& window,
            const std::vector<CurvePart>& parts, double end, Point&& point) const {
    constexpr std::array kVerdicts = {"box all inside: kept\n", "box beyond a side: dropped\n",
                                      "box across: the curve decides\n"};
    const std::string told = kVerdicts[static_cast<std::size_t>(place_of_box(window, box))];
    for (int i = 0; i < kPieces; ++i) {
      const double t = end * i / kPieces, next = end * (i + 1) / kPieces;
      const glm::dvec2 a = point(t), b = point(next);
      ink_line(track, world(), world().middle_of(a), world().middle_of(b), theme::kRed);
      for_each_kept(parts, {t, next}, end, [&](const CurvePart& part) {
        ink_line(track, world(), world().middle_of(point(part.from)),
                 world().middle_of(point(part.to)), theme::kText);
      });
      track.step({next, b.x, b.y}, told);
    }
  }

  void add_parts(Course& course, const char* name, const std::vector<CurvePart>& parts,
                 double unit) const {
    std::string text =
        fmt::format("{}: {} part{}", name, parts.size(), parts.size() == 1 ? "" : "s");
    for (const CurvePart& part : parts) {
      text += fmt::format(", {:.3g} to {:.3g}", part.from * unit, part.to * unit);
    }
    course.remarks.push_back(text);
  }

  void ellipse(Course& course, Track& track, const ClipWindow& window, int centre) const {
    const ClipWindow quarter = between(centre, centre + 1);
    ClippedEllipse e;
    e.centre = named_point(centre);
    e.radii = quarter.max - quarter.min;
    const ClipWindow box{e.centre - e.radii, e.centre + e.radii};
    add_box(course, box, theme::kDim);
    const auto parts = clip_ellipse(window, e);
    const double turn = 2 * std::numbers::pi;
    walk(track, box, window, parts, turn,
         [&](double a) { return e.centre + e.radii * glm::dvec2(std::cos(a), std::sin(a)); });
    add_parts(course, centre == kA ? "first, degrees" : "second, degrees", parts,
              180 / std::numbers::pi);
  }

  void bezier(Course& course, Track& track, const ClipWindow& window) const {
    std::vector<glm::dvec2> control;
    for (int i = kA; i <= kD; ++i) {
      check_coordinates(pixel(i));
      control.push_back(named_point(i));
    }
    ClipWindow box{control[0], control[0]};
    std::vector<glm::dvec2> polygon;
    for (const glm::dvec2& p : control) {
      box = {glm::min(box.min, p), glm::max(box.max, p)};
      polygon.push_back(world().middle_of(p));
    }
    guide_chain(course, polygon, theme::kKeyCap);
    add_box(course, box, theme::kDim);
    const auto parts = clip_bezier(window, control);
    walk(track, box, window, parts, 1,
         [&](double t) { return bezier_point(std::span<const glm::dvec2>(control), t); });
    add_parts(course, "t", parts, 1);
  }

  Course record() const override {
    const ClipWindow window = between(kLow, kHigh);
    Course course;
    Track track("curve", {"t", "x", "y"});
    if (knob(kCurve).index() == kEllipse) {
      ellipse(course, track, window, kA);
      ellipse(course, track, window, kC);
    } else {
      bezier(course, track, window);
    }
    add_box(course, window, theme::kCool);
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo curve_clipping_demo() {
  return {"curve-clipping",
          "7 Viewing and clipping",
          "Ellipses and Bezier curves clipped by their boxes, then exactly",
          [](const DemoSetup& setup) { return std::make_unique<CurveClipping>(setup); },
          1,
          "drag points and corners",
          {"curves clipped"}};
}

}  // namespace kinescope
