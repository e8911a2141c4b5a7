// Shear of a unit square: along x, along y, one after the other, or both at once.
#include <fmt/format.h>

#include <cmath>

#include "demos/space_course.h"
#include "engine/transform/transform2d.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kOrder };
enum { kXThenY, kYThenX, kAtOnce };
enum { kAlongX, kAlongY };
constexpr double kReach = 2.6;

class Practical6 : public ClonableDemo<Practical6, Lesson> {
 public:
  explicit Practical6(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "A shear keeps the area 1; both at once do not (1 - ab). The order of two "
                         "shears matters. Drag anywhere: across shears along x, up along y.",
             .figures = {{"along x, a", 0.75, -2, 2, 0.05}, {"along y, b", 0.5, -2, 2, 0.05}},
             .resolution = 6,
             .speed = 3},
            {choice_knob("order", {"1", "2", "3"}, {"x, then y", "y, then x", "at once"}, kXThenY,
                         "which shear acts first")}) {}

 private:
  bool dragging() const override { return held_.has_value(); }
  bool answer(const InputEvent& event, LessonScreen::Spot at) override {
    if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kLeft) {
      held_ = at.at;
      held_shears_ = {figure(kAlongX), figure(kAlongY)};
    }
    if (event.kind == InputKind::kMouseUp && held_) {
      held_.reset();
      return true;  // now it is played from its start
    }
    if (event.kind != InputKind::kMouseMove || !held_) return false;
    const double scale = 0.5 * std::min(world().columns(), world().rows()) / kReach;
    const glm::dvec2 by = (at.at - *held_) / scale;
    set_figure(kAlongX, std::round(20 * (held_shears_.x + by.x)) / 20);
    set_figure(kAlongY, std::round(20 * (held_shears_.y - by.y)) / 20);
    return true;
  }

  Course record() const override {
    const double a = figure(kAlongX), b = figure(kAlongY);
    if (!(std::abs(a) <= 100 && std::abs(b) <= 100)) throw_bad_input("shears: from -100 to 100");
    SpaceCourse square{.view = {world(), {}, {0.5, 0.5, 0}, kReach}};
    const TransformStep3 x{"along x", in_space(shear(a, 0))}, y{"along y", in_space(shear(0, b))};
    switch (knob(kOrder).index()) {
      case kXThenY:
        square.steps = {x, y};
        break;
      case kYThenX:
        square.steps = {y, x};
        break;
      default:
        square.steps = {{"both at once", in_space(shear(a, b))}};
    }
    square.flat = true;
    square.smooth = 20;
    square.figure.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.figure.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    square.traced = 2;
    const glm::dmat4 product = compose(square.steps);
    Course course;
    show(std::move(square), course, 0, "the corner (1, 1)");
    const double area = product[0].x * product[1].y - product[1].x * product[0].y;
    course.remarks.push_back(fmt::format("area {:.4g}", area));
    return course;
  }

  std::optional<glm::dvec2> held_;
  glm::dvec2 held_shears_{0};
};

}  // namespace

DemoInfo practical_6_demo() {
  return {"practical-6",
          "Practicals",
          "Practical 6: shear of a unit square, along x, along y, and both",
          [](const DemoSetup& setup) { return std::make_unique<Practical6>(setup); },
          1,
          "drag to shear",
          {"practical 6"}};
}

}  // namespace kinescope
