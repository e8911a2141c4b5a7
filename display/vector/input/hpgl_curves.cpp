// Arcs, circles, wedges and Bezier curves as a plotter draws them: in chords.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "display/vector/input/hpgl_plotter.h"

namespace kinescope {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kMostTurns = 2;  // a longer arc draws nothing new

/// Calls sink(degrees from the start) for the end of each chord.
template <typename Sink>
void for_each_chord(double degrees, double chord_degrees, Sink&& sink) {
  const double sweep = std::clamp(degrees, -360 * kMostTurns, 360 * kMostTurns);
  const double chord = std::clamp(std::abs(chord_degrees), 0.5, 180.0);
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / chord - 1e-9)));
  for (int i = 1; i <= count; ++i) sink(sweep * i / count);
}

glm::dvec2 rotated(glm::dvec2 v, double degrees) {
  const double c = std::cos(degrees * kRadians), s = std::sin(degrees * kRadians);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace

void hpgl_arc(HpglPlotter& plotter, glm::dvec2 centre_user, double degrees, double chord_degrees) {
  const glm::dvec2 radius = plotter.user_units(plotter.pen) - centre_user;
  for_each_chord(degrees, chord_degrees, [&](double turned) {
    plotter.go(plotter.plotter_units(centre_user + rotated(radius, turned)));
  });
}

/// The circle through three points; a straight line if they lie on one.
void hpgl_arc_through(HpglPlotter& plotter, glm::dvec2 middle, glm::dvec2 end,
                      double chord_degrees) {
  const glm::dvec2 start = plotter.user_units(plotter.pen);
  const glm::dvec2 a = middle - start, b = end - start;
  const double cross = 2 * (a.x * b.y - a.y * b.x);
  if (std::abs(cross) < 1e-9 * (glm::dot(a, a) + glm::dot(b, b))) {
    return plotter.go(plotter.plotter_units(end));
  }
  const double aa = glm::dot(a, a), bb = glm::dot(b, b);
  const glm::dvec2 centre = start + glm::dvec2(b.y * aa - a.y * bb, a.x * bb - b.x * aa) / cross;
  const auto angle = [&](glm::dvec2 p) {
    return std::atan2(p.y - centre.y, p.x - centre.x) / kRadians;
  };
  double sweep = std::fmod(angle(end) - angle(start) + 720, 360);
  if (cross < 0) sweep -= 360;
  hpgl_arc(plotter, centre, sweep, chord_degrees);
}

void hpgl_circle(HpglPlotter& plotter, double radius_user, double chord_degrees) {
  const glm::dvec2 centre = plotter.pen, centre_user = plotter.user_units(centre);
  HpglContour contour;
  glm::dvec2 from = plotter.plotter_units(centre_user + glm::dvec2(radius_user, 0));
  contour.points.push_back(from);
  contour.edges.push_back(false);
  for_each_chord(360, chord_degrees, [&](double turned) {
    const glm::dvec2 to =
        plotter.plotter_units(centre_user + rotated(glm::dvec2(radius_user, 0), turned));
    plotter.stroke(from, to);
    contour.points.push_back(to);
    contour.edges.push_back(true);
    from = to;
  });
  plotter.dot_due = false;
  if (!plotter.in_polygon) return;
  plotter.polygon.push_back(std::move(contour));
  plotter.new_contour();
}

/// Fifty chords.
void hpgl_bezier(HpglPlotter& plotter, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to) {
  const glm::dvec2 from = plotter.pen;
  constexpr int kChords = 50;
  for (int i = 1; i <= kChords; ++i) {
    const double t = static_cast<double>(i) / kChords, s = 1 - t;
    plotter.go(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
  }
}

HpglContour hpgl_wedge(const HpglPlotter& plotter, double radius_user, double start_degrees,
                       double sweep_degrees, double chord_degrees) {
  const glm::dvec2 centre = plotter.user_units(plotter.pen);
  HpglContour contour;
  const auto add = [&](glm::dvec2 user) {
    contour.points.push_back(plotter.plotter_units(user));
    contour.edges.push_back(true);
  };
  const glm::dvec2 radius = rotated({radius_user, 0}, start_degrees);
  add(centre);
  add(centre + radius);
  for_each_chord(std::clamp(sweep_degrees, -360.0, 360.0), chord_degrees,
                 [&](double turned) { add(centre + rotated(radius, turned)); });
  add(centre);
  return contour;
}

}  // namespace kinescope
