// What makes a curve of points easy to lead: no line meets it more often than its polygon, and
// turned points give the turned curve. A polynomial y(x) through the points has neither.
#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "demos/lesson/chart.h"
#include "engine/curves/b_spline.h"
#include "engine/curves/bezier.h"
#include "engine/curves/convex_hull.h"
#include "engine/transform/exact_angle.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kKind, kTurn };
enum { kBezier, kBSpline, kPolynomial };

constexpr int kPoints = 6, kSteps = 240;
using Points = std::vector<glm::dvec2>;

/// Source: Lagrange's form.
glm::dvec2 polynomial_point(const Points& points, double t) {
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const double x = std::lerp(low->x, high->x, t);
  double y = 0;
  for (const glm::dvec2& p : points) {
    double share = p.y;
    for (const glm::dvec2& q : points) {
      if (&p == &q) continue;
      if (std::abs(p.x - q.x) < 1e-6)
        throw_bad_input("y(x) cannot pass two points one above another");
      share *= (x - q.x) / (p.x - q.x);
    }
    y += share;
  }
  return {x, y};
}

class CurveProperties : public ClonableDemo<CurveProperties, Lesson> {
 public:
  explicit CurveProperties(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "Drag the line a-b: it meets the curve no more often than the "
                                  "polygon. 3 is y(x): it swings out, and is another when turned.",
                      .handles = {{"p0", {0.1, 0.5}},
                                  {"p1", {0.2, 0.42}},
                                  {"p2", {0.4, 0.6}},
                                  {"p3", {0.6, 0.4}},
                                  {"p4", {0.8, 0.58}},
                                  {"p5", {0.9, 0.5}},
                                  {"a", {0.05, 0.52}},
                                  {"b", {0.95, 0.48}}},
                      .resolution = 7,
                      .speed = 4},
                     {choice_knob("curve", {"1", "2", "3"}, {"Bezier", "B-spline", "y(x)"}, kBezier,
                                  "of the same points"),
                      number_knob("turn", "4", "5", -180, 180, 5, 35, "deg",
                                  "of the points in the second pane")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }
  bool handle_in(int, int pane) const override { return pane == 0; }

  Points curve(const Points& control) const {
    BSpline<glm::dvec2> spline{4, control, open_knots(4, kPoints)};
    Points points;
    for (int i = 0; i <= kSteps; ++i) {
      const double t = double(i) / kSteps;
      const int kind = knob(kKind).index();
      points.push_back(kind == kBezier    ? bezier_point(std::span<const glm::dvec2>(control), t)
                       : kind == kBSpline ? b_spline_point(spline, t)
                                          : polynomial_point(control, t));
    }
    return points;
  }
  Points turned(Points points) const {
    const glm::dvec2 centre = 0.5 * glm::dvec2(world().columns(), world().rows());
    const auto [s, c] = sine_cosine_deg(knob(kTurn).value);
    for (glm::dvec2& p : points) {
      const glm::dvec2 off = p - centre;
      p = centre + glm::dvec2(c * off.x - s * off.y, s * off.x + c * off.y);
    }
    return points;
  }
  Track drawn(const char* name, const Points& points, int pane, Srgb8 ink) const {
    Track track(name, {"t", "x", "y"}, pane, ink);
    InkPen pen(ink);
    for (std::size_t i = 0; i < points.size(); ++i) {
      pen.to(track, world(), points[i]);
      track.step({double(i) / kSteps, points[i].x, points[i].y});
    }
    return track;
  }

  Course record() const override {
    Points control;
    for (int i = 0; i < kPoints; ++i) pixel(i), control.push_back(corner(i));
    const glm::dvec2 a = corner(kPoints), b = corner(kPoints + 1);
    Course course;
    const Points flat = curve(control), after = turned(flat), anew = curve(turned(control));
    guide_chain(course, control, theme::kCool, 0);
    guide_chain(course, turned(control), theme::kCool, 1);
    course.guides.push_back({a, b, theme::kGreen, 0});
    course.tracks = {drawn("curve", flat, 0, theme::kText),
                     drawn("turned curve", after, 1, theme::kAccent),
                     drawn("curve of turned points", anew, 1, theme::kText)};
    double apart = 0;
    for (std::size_t i = 0; i < anew.size(); ++i) {
      apart = std::max(apart, glm::length(anew[i] - after[i]));
    }
    const auto hull = convex_hull(control);
    const bool inside = std::all_of(flat.begin(), flat.end(), [&](const glm::dvec2& p) {
      return hull_contains(hull, p) || hull_contains(hull, p + 1e-9 * (hull[0] - p));
    });
    course.remarks = {
        fmt::format("crossings of the polygon by the line: {}", line_crossings(control, a, b)),
        fmt::format("and of the curve: {}", line_crossings(flat, a, b)),
        inside ? "the hull holds the curve" : "the curve leaves the hull",
        fmt::format("turned and anew: {:.2g} pixels apart", apart)};
    return course;
  }
};

}  // namespace

DemoInfo curve_properties_demo() {
  return {"curve-properties",
          "9 Curves and fractals",
          "Variation diminishing and axis independence, beside a polynomial that has neither",
          [](const DemoSetup& setup) { return std::make_unique<CurveProperties>(setup); },
          1,
          "drag the points and the line",
          {"variation diminishing", "axis independence"}};
}

}  // namespace kinescope
