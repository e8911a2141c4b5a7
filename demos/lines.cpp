// Lines by the digital differential analyzer and by Bresenham, value by value.
#include "demos/lesson/lesson.h"
#include "demos/lesson/line_tracks.h"

namespace kinescope {
namespace {

enum { kMethod };
enum { kDda, kBresenham, kBoth };
enum { kFrom, kTo };

class Lines : public ClonableDemo<Lines, Lesson> {
 public:
  Lines(const DemoSetup& setup, bool centred)
      : ClonableDemo(setup,
                     {.look_for = "Both choose the same pixels, if none lies halfway: the DDA "
                                  "rounds a real number, Bresenham "
                                  "looks at a sign. Drag an end, or type it; n and b step.",
                      .handles = {{"from", {0.15, 0.3}}, {"to", {0.85, 0.6}}},
                      .centred = centred},
                     {choice_knob("method", {"1", "2", "3"}, {"DDA", "Bresenham", "both"},
                                  centred ? kBresenham : kBoth, "which algorithm draws")}),
        centred_(centred) {}

 private:
  glm::ivec2 panes() const override { return {knob(kMethod).index() == kBoth ? 2 : 1, 1}; }

  Course record() const override {
    const glm::ivec2 from = pixel(kFrom), to = pixel(kTo);
    Course course;
    const int method = knob(kMethod).index();
    if (method != kBresenham) course.tracks.push_back(dda_track(from, to, world()));
    if (method != kDda)
      course.tracks.push_back(bresenham_track(from, to, world(), method == kBoth));
    course.compare = method == kBoth;
    course.guides.push_back({corner(kFrom), corner(kTo)});
    if (centred_) {
      const glm::dvec2 origin(world().columns() / 2 + 0.5, world().rows() / 2 + 0.5);
      course.guides.push_back({{0, origin.y}, {2 * origin.x, origin.y}, theme::kDim});
      course.guides.push_back({{origin.x, 0}, {origin.x, 2 * origin.y}, theme::kDim});
    }
    if (from == to) course.remarks.emplace_back("The ends are one pixel: the line has no length.");
    return course;
  }

  bool centred_;
};

}  // namespace

DemoInfo lines_demo() {
  return {"lines",
          "2 Scan conversion",
          "DDA and Bresenham's line, step by step and value by value",
          [](const DemoSetup& setup) { return std::make_unique<Lines>(setup, false); },
          1,
          "drag an end",
          {"DDA line", "Bresenham line, all octants", "compare DDA with Bresenham value by value"}};
}

DemoInfo practical_1_demo() {
  DemoInfo info = lines_demo();
  info.name = "practical-1";
  info.chapter = "Practicals";
  info.summary = "Lines by DDA and Bresenham from typed or dragged end points, in a table";
  info.topics = {"practical 1"};
  return info;
}

DemoInfo practical_3_demo() {
  return {"practical-3",
          "Practicals",
          "Lines with the origin in the middle of the screen and four quadrants",
          [](const DemoSetup& setup) { return std::make_unique<Lines>(setup, true); },
          1,
          "drag an end",
          {"practical 3"}};
}

}  // namespace kinescope
