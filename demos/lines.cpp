// Lines by the digital differential analyzer and by Bresenham, value by value.
#include "demos/lesson/lesson.h"
#include "raster/scan/bresenham_steps.h"
#include "raster/scan/dda_line.h"

namespace kinescope {
namespace {

enum { kMethod };
enum { kDda, kBresenham, kBoth };
enum { kFrom, kTo };

class Lines : public ClonableDemo<Lines, Lesson> {
 public:
  explicit Lines(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Both must choose the same pixels: the DDA rounds a real number, "
                         "Bresenham looks at a sign. Drag an end, or type it; n and b step.",
             .handles = {{"from", {0.15, 0.25}}, {"to", {0.8, 0.7}}}},
            {choice_knob("method", {"1", "2", "3"}, {"DDA", "Bresenham", "both"}, kBoth,
                         "which algorithm draws")}) {}

 private:
  glm::ivec2 panes() const override { return {knob(kMethod).index() == kBoth ? 2 : 1, 1}; }

  Course record() const override {
    const glm::ivec2 from = pixel(kFrom), to = pixel(kTo);
    check_coordinates(from);
    check_coordinates(to);
    Course scene;
    const int method = knob(kMethod).index();
    if (method != kBresenham) {
      Track dda("DDA", {"x", "y"});
      for (DdaLine line(from, to); line.next();) {
        dda(line.at().x, line.at().y);
        dda.step({line.position().x, line.position().y});
      }
      scene.tracks.push_back(std::move(dda));
    }
    if (method != kDda) {
      Track track("Bresenham", {"x", "y", "d"}, method == kBoth ? 1 : 0);
      for (BresenhamSteps line(from, to); line.next();) {
        track(line.at().x, line.at().y);
        track.step({double(line.at().x), double(line.at().y), double(line.decision())});
      }
      scene.tracks.push_back(std::move(track));
    }
    scene.compare = method == kBoth;
    scene.guides.push_back({corner(kFrom), corner(kTo)});
    if (from == to) scene.remarks.push_back("The ends are one pixel: the line has no length.");
    return scene;
  }
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Lines>(setup); }

}  // namespace

DemoInfo lines_demo() {
  return {"lines",
          "2 Scan conversion",
          "DDA and Bresenham's line, step by step and value by value",
          create,
          1,
          "drag an end",
          {"DDA line", "Bresenham line, all octants", "compare DDA with Bresenham value by value"}};
}

}  // namespace kinescope
