// A plane by three points or by a point and its normal, and what affine maps make of both.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "demos/lesson/space_lesson.h"
#include "engine/transform/in_between.h"
#include "engine/transform/plane.h"

namespace kinescope {
namespace {

enum { kGiven, kMap };
enum { kThreePoints, kNormal };
enum { kA, kB, kC };
constexpr int kSmooth = 30;  // pictures of the map
constexpr double kArrow = 1.5;

class PlanesAndNormals : public ClonableDemo<PlanesAndNormals, SpaceLesson> {
 public:
  explicit PlanesAndNormals(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Carried like a point, a normal (red) leans away from its plane under "
                         "scaling and shear; by the inverse transpose (green) it stays square to "
                         "it. Rotations forgive both. Drag to look around.",
             .figures = {{"y of a, nx", 0.25, -2, 2, 0.25},
                         {"y of b, ny", 1, -2, 2, 0.25},
                         {"y of c, nz", 0.5, -2, 2, 0.25}},
             .resolution = 7,
             .speed = 3},
            {choice_knob("given", {"1", "2"}, {"three points", "point and normal"}, kThreePoints,
                         "what the plane is made from"),
             choice_knob("map", {"y"}, {"scaling", "shear", "rotation", "reflection"}, 0,
                         "what happens to the plane")}) {}

 private:
  glm::dmat4 map() const {
    switch (knob(kMap).index()) {
      case 0:
        return scaling({1.6, 0.5, 1});
      case 1:
        return shear({.a = 1.2});
      case 2:
        return rotation_about_deg({{}, {1, 1, 0}}, 60);
      default:
        return scaling({-1, 1, 1});
    }
  }
  std::array<glm::dvec3, 3> points() const {
    return {{{-1.2, figure(kA), 1}, {1.2, figure(kB), 1}, {0, figure(kC), -1.4}}};
  }
  Plane plane() const {
    if (knob(kGiven).index() == kNormal) {
      return plane_by_normal({0, 0.5, 0}, {figure(kA), figure(kB), figure(kC)});
    }
    const auto p = points();
    return plane_by_points(p[0], p[1], p[2]);
  }

  /// A square of the plane about the foot of the origin, with lines across.
  static Wire patch(const Plane& plane) {
    const glm::dvec3 n = plane.unit_normal, foot = plane.from_origin * n;
    const glm::dvec3 other = std::abs(n.y) > 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(n, other)), v = glm::cross(n, u);
    Wire wire;
    for (int i = -3; i <= 3; ++i) {
      for (const auto& [along, across] : {std::pair(u, v), std::pair(v, u)}) {
        const glm::dvec3 middle = foot + (0.5 * i) * across;
        wire.edges.push_back({wire.points.size(), wire.points.size() + 1});
        wire.points.push_back(middle - 1.5 * along);
        wire.points.push_back(middle + 1.5 * along);
      }
    }
    return wire;
  }

  Course record() const override {
    const Plane plane = this->plane();
    const glm::dmat4 map = this->map();
    const glm::dvec3 foot = plane.from_origin * plane.unit_normal;
    Track track("plane", {"share", "nx", "ny", "nz", "leans"});
    for (int i = 0; i <= kSmooth; ++i) {
      const glm::dmat4 part = in_between(map, double(i) / kSmooth);
      // A reflection passes through what is flat.
      if (std::abs(glm::determinant(glm::dmat3(part))) < 1e-6) continue;
      const glm::dvec3 right = mapped_normal(part, plane.unit_normal);
      const glm::dvec3 naive = glm::normalize(glm::dmat3(part) * plane.unit_normal);
      const double leans = std::acos(std::clamp(std::abs(glm::dot(right, naive)), 0.0, 1.0));
      track.step({double(i) / kSmooth, right.x, right.y, right.z, leans * (180 / std::numbers::pi)},
                 matrix_lines(part));
    }
    Course course;
    const glm::dvec3& n = plane.unit_normal;
    course.remarks.push_back(
        fmt::format("{:.3f} x {:+.3f} y {:+.3f} z = {:.3f}", n.x, n.y, n.z, plane.from_origin));
    const Plane mapped = mapped_plane(map, plane);
    course.remarks.push_back(fmt::format("mapped: {:.3f} x {:+.3f} y {:+.3f} z = {:.3f}",
                                         mapped.unit_normal.x, mapped.unit_normal.y,
                                         mapped.unit_normal.z, mapped.from_origin));
    course.tracks.push_back(std::move(track));
    const SpacePane space = view({0, 0.5, 0}, 3.2);
    const Wire wire = patch(plane);
    const auto part = [map](std::size_t shown) {
      const double share = std::min(double(shown) / kSmooth, 1.0);
      return in_between(map, share);
    };
    course.painter = [space, wire, part](std::size_t shown, int, Image<Srgb8>& paper) {
      PaperInk ink{paper};
      ink_wire(ink, space, wire, glm::dmat4(1.0), theme::kKeyCap);
      ink_wire(ink, space, wire, part(shown), theme::kAccent);
    };
    const bool three = knob(kGiven).index() == kThreePoints;
    course.overlay = [space, part, plane, foot, three, points = points()](std::size_t shown) {
      Overlay over;
      space.add_axes(over, 2, 0);
      const glm::dmat4 m = part(shown);
      const glm::dvec3 from = apply(m, foot);
      const auto arrow = [&](const glm::dvec3& normal, Srgb8 ink) {
        space.add_line(over, from, from + kArrow * glm::normalize(normal), ink, 0);
      };
      arrow(glm::dmat3(m) * plane.unit_normal, theme::kRed);
      if (std::abs(glm::determinant(glm::dmat3(m))) > 1e-6) {
        arrow(mapped_normal(m, plane.unit_normal), theme::kGreen);
      }
      for (std::size_t i = 0; three && i < 3; ++i) {
        space.add_label(over, apply(m, points[i]), std::string(1, "abc"[i]), theme::kText, 0);
      }
      return over;
    };
    return course;
  }
};

}  // namespace

DemoInfo planes_and_normals_demo() {
  return {"planes-and-normals",
          "5 Three-dimensional transformations",
          "A plane by three points or its normal, and normals under scaling, shear and rotation",
          [](const DemoSetup& setup) { return std::make_unique<PlanesAndNormals>(setup); },
          1,
          "drag to look around",
          {"planes by three points and by point and normal", "normals under affine maps"}};
}

}  // namespace kinescope
