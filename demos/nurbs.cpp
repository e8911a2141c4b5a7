// Rational curves: weights pull a curve towards its points, and make conics exact.
#include "engine/curves/nurbs.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "demos/lesson/chart.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kShape };
enum { kFree, kConic, kCircle };
enum { kCentre = 2, kRim = 5 };  // handles

constexpr int kSteps = 240;

class Nurbs : public ClonableDemo<Nurbs, Lesson> {
 public:
  explicit Nurbs(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Move a weight: the curve (white) nears its point, the one of "
                         "equal weights (amber) stays. 2: conics. 3: a circle, if w2 is 1.",
             .handles = {{"p0", {0.12, 0.7}},
                         {"p1", {0.15, 0.3}},
                         {"p2", {0.5, 0.5}},
                         {"p3", {0.85, 0.3}},
                         {"p4", {0.88, 0.7}},
                         {"rim", {0.85, 0.5}}},
             .figures = {{"w1", 4, 0, 5, 0.05}, {"w2", 1, 0, 5, 0.05}, {"w3", 1, 0, 5, 0.05}},
             .resolution = 7,
             .speed = 4},
            {choice_knob("shape", {"1", "2", "3"}, {"free", "conic", "circle"}, kFree,
                         "five points, a conic's three, or a circle's nine")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }
  bool handle_in(int handle, int pane) const override {
    if (pane != 0) return false;
    const int shape = knob(kShape).index();
    if (shape == kCircle) return handle == kCentre || handle == kRim;
    return handle != kRim && (shape == kFree || handle % 2 == 0);
  }

  double weight(int index) const {
    const double w = figure(index);
    if (!(w >= 0 && w <= 1e6)) throw_bad_input("weights: from 0 to a million");
    return w;
  }
  double radius() const { return glm::length(corner(kRim) - corner(kCentre)); }

  NurbsCurve curve() const {
    for (std::size_t i = 0; i < corners(); ++i) pixel(static_cast<int>(i));
    if (knob(kShape).index() == kConic) {
      return conic_arc(corner(0), corner(2), corner(4), weight(1));
    }
    if (knob(kShape).index() == kCircle) {
      NurbsCurve circle = nurbs_circle(corner(kCentre), radius());
      for (std::size_t i = 1; i < circle.control.size(); i += 2) circle.control[i] *= weight(1);
      return circle;
    }
    const std::array weights = {1.0, weight(0), weight(1), weight(2), 1.0};
    std::vector<glm::dvec2> control;
    for (int i = 0; i < 5; ++i) control.push_back(corner(i));
    return nurbs_curve(4, control, weights, open_knots(4, 5));
  }

  Track blending(Course& course, const NurbsCurve& nurbs) const {
    Track track("rational blending functions", {}, 1);
    const Chart chart(world(), {0, 0}, {1, 1});
    chart.axes(course, 1);
    std::vector<InkPen> pens = chart_pens(nurbs.control.size());
    for (int k = 0; k <= kSteps; ++k) {
      const double t = double(k) / kSteps;
      const std::vector<double> shares = rational_basis(nurbs, t);
      for (std::size_t i = 0; i < shares.size(); ++i) {
        pens[i].to(track, world(), chart.place({t, shares[i]}));
      }
      track.step({});
    }
    return track;
  }

  Track drawn(const char* name, const NurbsCurve& nurbs, Srgb8 ink) const {
    Track track(name, {"t", "x", "y"}, 0, ink);
    InkPen pen(ink);
    for (int k = 0; k <= kSteps; ++k) {
      const double t = double(k) / kSteps;
      const glm::dvec2 p = nurbs_point(nurbs, t);
      pen.to(track, world(), p);
      track.step({t, p.x, p.y});
    }
    return track;
  }

  std::string told(const NurbsCurve& nurbs) const {
    const int shape = knob(kShape).index();
    if (shape == kFree) return "each weight pulls the curve to its point; 0 lets go";
    if (shape == kConic) {
      const double w = weight(1);
      return w == 0   ? "a straight line"
             : w < 1  ? "an ellipse"
             : w == 1 ? "a parabola"
                      : "a hyperbola";
    }
    double off = 0;
    for (int k = 0; k <= kSteps; ++k) {
      const glm::dvec2 p = nurbs_point(nurbs, double(k) / kSteps);
      off = std::max(off, std::abs(glm::length(p - corner(kCentre)) - radius()));
    }
    return fmt::format("furthest off the circle: {:.3g} pixels", off);
  }

  Course record() const override {
    const NurbsCurve nurbs = curve();
    NurbsCurve plain = nurbs;
    std::vector<glm::dvec2> control;
    for (glm::dvec3& p : plain.control) {
      if (p.z > 0) p /= p.z;  // a point of no weight is gone: it stays where it is
      control.emplace_back(p);
      if (!(p.z > 0)) p = glm::dvec3(corner(2), 1);
    }
    Course course;
    guide_chain(course, control, theme::kCool, 0);
    course.tracks = {drawn("equal weights", plain, theme::kAccent),
                     drawn("rational", nurbs, theme::kText), blending(course, nurbs)};
    course.remarks = {told(nurbs)};
    return course;
  }
};

}  // namespace

DemoInfo nurbs_demo() {
  return {"nurbs",
          "9 Curves and fractals",
          "Rational B-splines: weights dragged, conics and a circle drawn exactly",
          [](const DemoSetup& setup) { return std::make_unique<Nurbs>(setup); },
          1,
          "drag points and weights",
          {"NURBS circle", "conics"}};
}

}  // namespace kinescope
