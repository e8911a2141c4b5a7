// Two-dimensional transformations of a triangle, step by step, the matrix and its class shown.
#include <fmt/format.h>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/transform/matrix_class.h"
#include "engine/transform/transform2d.h"

namespace kinescope {
namespace {

enum { kKind, kAmount, kMeaning };
enum {
  kIdentity,
  kTranslation,
  kRotation,
  kUniform,
  kDifferential,
  kShearX,
  kShearY,
  kInLine,
  kInX,
  kInY,
  kInOrigin,
  kInDiagonal
};
enum { kPivot = 3 };

class Transformations : public ClonableDemo<Transformations, Lesson> {
 public:
  explicit Transformations(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Steps act one after another; the product acts at once. A coordinate "
                         "transformation is the inverse: the axes move. Drag corners and pivot.",
             .handles = {{"a", {0.6, 0.4}},
                         {"b", {0.85, 0.4}},
                         {"c", {0.75, 0.15}},
                         {"pivot", {0.5, 0.5}}},
             .resolution = 5,
             .speed = 0,
             .centred = true},
            {choice_knob("kind", {"y"},
                         {"identity", "translation", "rotation", "scaling", "differential scaling",
                          "shear along x", "shear along y", "reflection in a line", "in x axis",
                          "in y axis", "in origin", "in y = x"},
                         kRotation, "about the pivot, or a line through it"),
             number_knob("amount", "1", "2", -3, 3, 0.125, 1, "",
                         "half right angles, factor, shear, slope or tens of pixels"),
             choice_knob("meaning", {"g"}, {"geometric", "coordinate"}, 0,
                         "the object moves, or the axes do")}) {}

 private:
  std::vector<TransformStep2> chain() const {
    const double amount = knob(kAmount).value;
    const glm::dvec2 pivot = named_point(kPivot);
    switch (knob(kKind).index()) {
      case kRotation:
        return rotation_about_steps(pivot, 45 * amount);
      case kUniform:
        return scaling_about_steps(pivot, glm::dvec2(amount));
      case kDifferential:
        return scaling_about_steps(pivot, glm::dvec2(amount, 1));
      case kShearX:
        return about_steps(pivot, "shear along x", shear(amount, 0));
      case kShearY:
        return about_steps(pivot, "shear along y", shear(0, amount));
      case kInLine:
        return reflection_in_line_steps(amount, pivot.y - amount * pivot.x);
      case kInX:
        return {{"reflection in the x axis", reflection_in_x_axis()}};
      case kInY:
        return {{"reflection in the y axis", reflection_in_y_axis()}};
      case kInOrigin:
        return {{"reflection in the origin", reflection_in_origin()}};
      case kInDiagonal:
        return {{"reflection in y = x", reflection_in_diagonal()}};
      case kTranslation:
        return {{"translation", translation(glm::dvec2(10 * amount))}};
      default:
        return {{"identity", glm::dmat3(1.0)}};
    }
  }

  void show(Track& track, const glm::dmat3& matrix, Srgb8 colour) const {
    const World pane = world();
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 a = apply(matrix, named_point(i));
      const glm::dvec2 b = apply(matrix, named_point((i + 1) % 3));
      ink_line(track, pane, pane.middle_of(a), pane.middle_of(b), colour);
    }
  }

  Course record() const override {
    for (int i = 0; i <= kPivot; ++i) pixel(i);
    std::vector<TransformStep2> steps = chain();
    if (knob(kMeaning).index() == 1) {
      std::reverse(steps.begin(), steps.end());
      for (TransformStep2& step : steps) step.matrix = coordinate_from_geometric(step.matrix);
    }
    constexpr std::array kInks = {theme::kCool, theme::kGreen, theme::kBlue, theme::kKeyCap,
                                  theme::kDim};
    Track track("triangle", {"x of a", "y of a"});
    const glm::dvec2 a = named_point(0);
    show(track, glm::dmat3(1.0), theme::kText);
    track.step({a.x, a.y}, "as it is");
    glm::dmat3 sofar(1.0);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      sofar = steps[i].matrix * sofar;
      show(track, sofar, i + 1 == steps.size() ? theme::kAccent : kInks[i % kInks.size()]);
      const glm::dvec2 now = apply(sofar, a);
      track.step({now.x, now.y}, steps[i].name);
    }
    Course course;
    course.tracks.push_back(std::move(track));
    for (int row = 0; row < 3; ++row) {
      course.remarks.push_back(
          fmt::format("[{:8.3f} {:8.3f} {:8.3f} ]", sofar[0][row], sofar[1][row], sofar[2][row]));
    }
    course.remarks.push_back(std::string("class: ") + class_name(transform_class(sofar)));
    const World pane = world();
    // Where it all leads.
    for (int i = 0; i < 3; ++i) {
      const auto goal = [&](int k) { return pane.middle_of(apply(sofar, named_point(k % 3))); };
      course.guides.push_back({goal(i), goal(i + 1), theme::kKeyCap});
    }
    const glm::dvec2 far(pane.columns(), pane.rows());
    course.guides.push_back({pane.middle_of({-far.x, 0}), pane.middle_of({far.x, 0}), theme::kDim});
    course.guides.push_back({pane.middle_of({0, -far.y}), pane.middle_of({0, far.y}), theme::kDim});
    return course;
  }
};

}  // namespace

DemoInfo transformations_demo() {
  return {"transformations",
          "3 Two-dimensional transformations",
          "A triangle turned, scaled, sheared, reflected and moved, matrix by matrix",
          [](const DemoSetup& setup) { return std::make_unique<Transformations>(setup); },
          1,
          "drag corners and pivot",
          {"identity", "scaling (uniform, differential, about a point)",
           "reflection (axes, origin, y=x, any line y=mx+c)", "shear (x, y)",
           "rotation (origin, pivot)", "translation", "composition", "homogeneous coordinates",
           "geometric against coordinate transformation", "classes (rigid, conformal, affine)"}};
}

}  // namespace kinescope
