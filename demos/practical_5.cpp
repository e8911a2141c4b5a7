// Transformations of a figure, in the plane and in space: up to three, one after the other.
#include <fmt/format.h>

#include "demos/space_course.h"
#include "engine/transform/transform2d.h"
#include "raster/scan/limits.h"

namespace kinescope {
namespace {

enum { kFirst, kSecond, kThird, kAxis };
enum { kNone, kMove, kTurn, kScale, kShear, kReflect };
enum { kAngle, kWay, kFactor, kShearing };
constexpr double kPlaneReach = 4;

Knob step_knob(const char* name, const char* key, int index) {
  return choice_knob(name, {key}, {"none", "move", "turn", "scale", "shear", "mirror"}, index,
                     "what happens to both figures");
}

class Practical5 : public ClonableDemo<Practical5, SpaceLesson> {
 public:
  explicit Practical5(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Three steps, chosen in their rows: change their order and see another "
                         "end. Drag the triangle's corners, or the space on the right to look "
                         "around.",
             .handles = {{"a", {0.55, 0.45}, 0}, {"b", {0.8, 0.45}, 0}, {"c", {0.7, 0.3}, 0}},
             .figures = {{"angle", 45, -180, 180, 5},
                         {"way", 1.5, -3, 3, 0.25},
                         {"factor", 1.5, -3, 3, 0.25},
                         {"shearing", 0.5, -3, 3, 0.25}},
             .resolution = 7,
             .speed = 3},
            {step_knob("first", "1", kTurn), step_knob("second", "2", kMove),
             step_knob("third", "3", kNone),
             choice_knob("axis", {"4"}, {"x", "y", "z"}, 1, "of turns in space")},
            1) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  TransformStep3 in_plane(int kind) const {
    const double way = figure(kWay);
    switch (kind) {
      case kMove:
        return {"move", in_space(translation(glm::dvec2(way, way / 2)))};
      case kTurn:
        return {"turn", in_space(rotation_deg(figure(kAngle)))};
      case kScale:
        return {"scale", in_space(scaling(figure(kFactor)))};
      case kShear:
        return {"shear along x", in_space(shear(figure(kShearing), 0))};
      default:
        return {"reflect in the y axis", in_space(reflection_in_y_axis())};
    }
  }
  TransformStep3 in_three(int kind) const {
    const double way = figure(kWay);
    switch (kind) {
      case kMove:
        return {"move", translation(glm::dvec3(way, way / 2, way))};
      case kTurn: {
        const int axis = knob(kAxis).index();
        const auto turn = axis == 0 ? rotation_x_deg : axis == 1 ? rotation_y_deg : rotation_z_deg;
        return {fmt::format("turn about {}", "xyz"[axis]), turn(figure(kAngle))};
      }
      case kScale:
        return {"scale", scaling(glm::dvec3(figure(kFactor)))};
      case kShear:
        return {"shear along x", shear({.a = figure(kShearing), .b = figure(kShearing)})};
      default:
        return {"reflect in x = 0", scaling({-1, 1, 1})};
    }
  }

  /// The dragged triangle in the pane's units, y up.
  Wire triangle(const SpacePane& pane) const {
    Wire wire;
    const double scale = 0.5 * std::min(pane.world.columns(), pane.world.rows()) / pane.reach;
    for (int i = 0; i < 3; ++i) {
      check_coordinates(pixel(i));
      const glm::dvec2 off = corner(i) - 0.5 * glm::dvec2(pane.world.columns(), pane.world.rows());
      wire.points.emplace_back(off.x / scale, -off.y / scale, 0.0);
      wire.edges.push_back({std::size_t(i), std::size_t(i + 1) % 3});
    }
    return wire;
  }

  Course record() const override {
    SpaceCourse plane{.view = {world(), {}, {}, kPlaneReach}};
    plane.flat = true;
    plane.figure = triangle(plane.view);
    plane.traced = 0;
    SpaceCourse space{.view = view({0, 0.5, 0}, 4)};
    for (int i = kFirst; i <= kThird; ++i) {
      const int kind = knob(i).index();
      if (kind == kNone) continue;
      plane.steps.push_back(in_plane(kind));
      space.steps.push_back(in_three(kind));
    }
    plane.smooth = space.smooth = 12;
    plane.brief = space.brief = true;
    Course course;
    show(std::move(plane), course, 0, "in the plane");
    show(std::move(space), course, 1, "in space");
    return course;
  }
};

}  // namespace

DemoInfo practical_5_demo() {
  return {"practical-5",
          "Practicals",
          "Practical 5: transformations of a figure, in two dimensions and in three",
          [](const DemoSetup& setup) { return std::make_unique<Practical5>(setup); },
          1,
          "drag corners, or to look around",
          {"practical 5"}};
}

}  // namespace kinescope
