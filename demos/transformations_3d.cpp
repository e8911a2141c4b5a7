// Three-dimensional transformations of a house, matrix by matrix, and in both orders.
#include <fmt/format.h>

#include "demos/lesson/space_lesson.h"
#include "demos/space_course.h"

namespace kinescope {
namespace {

enum { kKind, kOrigin, kOrder, kSmooth };
enum { kTranslation, kScaling, kRotateX, kRotateY, kRotateZ, kAnyAxis, kShear, kPlane, kHalfTurn };
enum { kAmount, kX, kY, kZ };
constexpr double kSecondTurnDeg = 60;
constexpr glm::dvec3 kThrough{0.8, 0.6, 0.4};  // axes and planes that miss the origin

class Transformations3D : public ClonableDemo<Transformations3D, SpaceLesson> {
 public:
  explicit Transformations3D(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for =
                 "Any axis: moved to the origin, turned onto z, the rotation, and all of it "
                 "back. o: with a turn about z before and after: where the houses differ, "
                 "the order matters. Drag to look around.",
             .figures = {{"angle", 120, -180, 180, 5},
                         {"x, a", 1, -3, 3, 0.25},
                         {"y, b", 1, -3, 3, 0.25},
                         {"z, d", 1, -3, 3, 0.25}},
             .resolution = 7,
             .speed = 3},
            {choice_knob("kind", {"y"},
                         {"move", "scale", "about x", "about y", "about z", "any axis", "shear",
                          "in a plane", "about a line"},
                         kAnyAxis, "x, y, z: the way, factors, shears, the axis or the normal"),
             toggle_knob("through the origin", "g", false, "of the axis or plane: five matrices"),
             toggle_knob("both orders", "o", false, "a turn about z after it and before it"),
             toggle_knob("smooth", "m", true, "in-betweens of each matrix")}) {}

 private:
  glm::ivec2 panes() const override { return {knob(kOrder).on() ? 2 : 1, 1}; }
  glm::dvec3 numbers() const { return {figure(kX), figure(kY), figure(kZ)}; }
  Axis axis() const { return {knob(kOrigin).on() ? glm::dvec3(0.0) : kThrough, numbers()}; }

  std::vector<TransformStep3> chain() const {
    const glm::dvec3 n = numbers();
    switch (knob(kKind).index()) {
      case kTranslation:
        return {{"translation", translation(n)}};
      case kScaling:
        return {{"scaling", scaling(n)}};
      case kRotateX:
        return {{"rotation about x", rotation_x_deg(figure(kAmount))}};
      case kRotateY:
        return {{"rotation about y", rotation_y_deg(figure(kAmount))}};
      case kRotateZ:
        return {{"rotation about z", rotation_z_deg(figure(kAmount))}};
      case kAnyAxis:
        return without_identities(rotation_about_steps(axis(), figure(kAmount)));
      case kShear:
        return {{"shear", shear({.a = n.x, .b = n.y, .d = n.z})}};
      case kPlane:
        return without_identities(reflection_in_plane_steps(plane_by_normal(axis().through, n)));
      default:
        return without_identities(rotation_about_steps(axis(), 180));
    }
  }

  /// The axis or the plane as it is carried along by the steps.
  void add_to(SpaceCourse& course) const {
    const int kind = knob(kKind).index();
    const glm::dvec3 p = axis().through, along = 2.5 * glm::normalize(numbers());
    if (kind == kAnyAxis || kind == kHalfTurn || kind == kPlane) {
      course.carried.points = {p - along, p + along};
      course.carried.edges = {{0, 1}};
    }
    if (kind != kPlane) return;
    const glm::dvec3 other = std::abs(along.y) > 2 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = 1.8 * glm::normalize(glm::cross(along, other));
    const glm::dvec3 v = 1.8 * glm::normalize(glm::cross(along, u));
    for (const glm::dvec3& corner : {u + v, v - u, -u - v, u - v}) {
      course.carried.points.push_back(p + corner);
    }
    for (std::size_t i = 0; i < 4; ++i) course.carried.edges.push_back({2 + i, 2 + (i + 1) % 4});
  }

  Course record() const override {
    SpaceCourse one{.view = view({0, 0.5, 0}, 3.2)};
    one.smooth = knob(kSmooth).on() ? 10 : 1;
    one.steps = chain();
    add_to(one);
    Course course;
    if (!knob(kOrder).on()) {
      show(std::move(one), course, 0, "house");
      course.remarks = class_remarks(compose(chain()));
      return course;
    }
    one.brief = true;
    SpaceCourse other = one;
    const TransformStep3 turn{"a turn about z", rotation_z_deg(kSecondTurnDeg)};
    one.steps.push_back(turn);
    other.steps.insert(other.steps.begin(), turn);
    other.carried = {};
    show(std::move(one), course, 0, "it, then a turn");
    show(std::move(other), course, 1, "a turn, then it");
    course.compare = true;
    return course;
  }
};

}  // namespace

DemoInfo transformations_3d_demo() {
  return {"transformations-3d",
          "5 Three-dimensional transformations",
          "A house moved, turned about any axis, scaled, sheared, reflected; the order of matrices",
          [](const DemoSetup& setup) { return std::make_unique<Transformations3D>(setup); },
          1,
          "drag to look around",
          {"three-dimensional scaling", "translation", "rotation about x, y, z and any axis",
           "shear", "reflection in a plane", "reflection about an axis", "composition"}};
}

}  // namespace kinescope
