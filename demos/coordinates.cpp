// Cartesian and polar coordinates of one point, on both grids.
#include <fmt/format.h>

#include <numbers>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/transform/polar.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kSpacing, kRays };
constexpr int kChords = 72;

class Coordinates : public ClonableDemo<Coordinates, Lesson> {
 public:
  explicit Coordinates(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "One point, two pairs of numbers. Drag it about the origin: the radius "
                         "stays, the angle leaps where it passes the left half of the x axis.",
             .handles = {{"point", {0.85, 0.3}}},
             .figures = {{"spacing", 10, 2, 40, 2}, {"rays", 12, 2, 36, 2}},
             .resolution = 6,
             .speed = 4,
             .centred = true},
            {}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  Course record() const override {
    const World pane = world();
    const double spacing = figure(kSpacing);
    if (!(spacing >= 1 && spacing <= 1000)) throw_bad_input("spacing: from 1 to 1000 pixels");
    const int rays = whole_figure(kRays);
    if (rays < 1 || rays > 360) throw_bad_input("rays: from 1 to 360");
    const glm::ivec2 whole = pixel(0);
    const glm::dvec2 point = pane.named(whole);
    const double reach = std::hypot(pane.columns(), pane.rows()) / 2;
    const auto place = [&](glm::dvec2 p) { return pane.of_name(p) + 0.5; };
    Track cartesian("Cartesian", {"x", "y"}, 0, theme::kKeyCap);
    Track polar("polar", {"radius", "degrees"}, 1, theme::kKeyCap);
    cartesian_grid(reach, spacing, [&](glm::dvec2 a, glm::dvec2 b) {
      ink_line(cartesian, pane, place(a), place(b), theme::kKeyCap);
      cartesian.step({b.x, b.y});
    });
    polar_grid(reach, spacing, rays, kChords, [&](glm::dvec2 a, glm::dvec2 b) {
      ink_line(polar, pane, place(a), place(b), theme::kKeyCap);
      const Polar at = polar_from_cartesian(b);
      polar.step({at.radius, degrees(at.angle_rad)});
    });
    const Polar at = polar_from_cartesian(point);
    ink_line(cartesian, pane, place({0, point.y}), place(point), theme::kRed);
    ink_line(cartesian, pane, place({point.x, 0}), place(point), theme::kGreen);
    cartesian.step({point.x, point.y});
    ink_line(polar, pane, place({0, 0}), place(point), theme::kRed);
    const double arc = std::min(at.radius, 2 * spacing);
    for (int i = 0; i < kChords; ++i) {
      const auto on_arc = [&](int k) {
        return place(cartesian_from_polar({arc, at.angle_rad * k / kChords}));
      };
      ink_line(polar, pane, on_arc(i), on_arc(i + 1), theme::kGreen);
    }
    polar.step({at.radius, degrees(at.angle_rad)});
    Course course;
    const glm::dvec2 back = cartesian_from_polar(at);
    course.remarks = {fmt::format("x = {:g}, y = {:g}", point.x, point.y),
                      fmt::format("radius = sqrt(x2 + y2) = {:.3f}", at.radius),
                      fmt::format("angle = atan2(y, x) = {:.2f} degrees", degrees(at.angle_rad)),
                      fmt::format("and back: r cos a = {:.3f}, r sin a = {:.3f}", back.x, back.y)};
    course.tracks = {std::move(cartesian), std::move(polar)};
    return course;
  }

  static double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }
};

}  // namespace

DemoInfo coordinates_demo() {
  return {"coordinates",
          "1 Displays and coordinates",
          "One point in Cartesian and in polar coordinates, on both grids",
          [](const DemoSetup& setup) { return std::make_unique<Coordinates>(setup); },
          1,
          "drag the point",
          {"Cartesian and polar coordinates", "conversions, both grids"}};
}

}  // namespace kinescope
