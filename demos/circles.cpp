// Circles five ways, their eight octants in colours, any two side by side.
#include "demos/lesson/circle_tracks.h"
#include "demos/lesson/lesson.h"

namespace kinescope {
namespace {

enum { kMethod, kBeside };

class Circles : public ClonableDemo<Circles, Lesson> {
 public:
  Circles(const DemoSetup& setup, int method)
      : ClonableDemo(
            setup,
            {.look_for = "One octant is decided, seven are its mirrors, each in a colour. Does any "
                         "method differ from the midpoint's? Drag the centre, type a radius.",
             .handles = {{"centre", {0.5, 0.5}}},
             .figures = {{"radius", 10, 0, 40, 1}},
             .resolution = 3,
             .speed = 2},
            {choice_knob("method", {"1", "2", "3", "4", "5"},
                         {"explicit", "parametric", "DDA", "Bresenham", "midpoint"}, method,
                         "how the circle is found"),
             toggle_knob("beside midpoint", "c", true,
                         "the midpoint circle too, and what differs")}) {}

 private:
  glm::ivec2 panes() const override { return {knob(kBeside).on() ? 2 : 1, 1}; }

  Course record() const override {
    Course course;
    const glm::ivec2 centre = pixel(0);
    const int radius = whole_figure(0);
    const auto method = static_cast<CircleMethod>(knob(kMethod).index());
    course.tracks.push_back(circle_track(method, centre, radius, 0));
    if (knob(kBeside).on()) {
      course.tracks.push_back(circle_track(CircleMethod::kMidpoint, centre, radius, 1));
    }
    course.compare = knob(kBeside).on();
    return course;
  }
};

}  // namespace

DemoInfo circles_demo() {
  return {"circles",
          "2 Scan conversion",
          "A circle by its explicit, parametric and DDA forms, by Bresenham and by midpoints",
          [](const DemoSetup& setup) { return std::make_unique<Circles>(setup, 3); },
          1,
          "drag the centre",
          {"explicit circle", "parametric circle", "DDA circle", "Bresenham circle",
           "midpoint circle", "eight-way symmetry"}};
}

DemoInfo practical_2_demo() {
  return {"practical-2",
          "Practicals",
          "Circles both ways: Bresenham's and the midpoint algorithm",
          [](const DemoSetup& setup) { return std::make_unique<Circles>(setup, 3); },
          1,
          "drag the centre",
          {"practical 2"}};
}

}  // namespace kinescope
