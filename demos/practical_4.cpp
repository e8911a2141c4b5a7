// A rubber-band line: drag it, fix it with the right button, move it with the arrows.
#include <fmt/format.h>

#include "demos/lesson/lesson.h"
#include "demos/lesson/line_tracks.h"

namespace kinescope {
namespace {

class RubberBand : public ClonableDemo<RubberBand, Lesson> {
 public:
  explicit RubberBand(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Press and drag: the line follows the mouse. The right button fixes "
                         "it, the arrows move it, c clears.",
             .handles = {{"from", {0.3, 0.4}}, {"to", {0.7, 0.6}}},
             .resolution = 2,
             .speed = 8},
            {choice_knob("method", {"1", "2"}, {"DDA", "Bresenham"}, 1, "how it is drawn")}) {}

 private:
  bool answer(const InputEvent& event, LessonScreen::Spot at) override {
    const glm::dvec2 p = glm::floor(at.at);
    if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kRight) {
      fixed_.push_back({handles()[0].at, handles()[1].at});
      rubber_ = false;
      return true;
    }
    if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kLeft) {
      handles()[0].at = handles()[1].at = p;
      return rubber_ = true;
    }
    if (event.kind == InputKind::kMouseUp) return std::exchange(rubber_, false);
    if (event.kind == InputKind::kMouseMove && rubber_) {
      handles()[1].at = p;
      return true;
    }
    return event.kind == InputKind::kKeyDown && key(event.key);
  }

  bool key(const std::string& key) {
    if (key == "c") {
      fixed_.clear();
      return true;
    }
    const glm::dvec2 move(int(key == "Right") - int(key == "Left"),
                          int(key == "Down") - int(key == "Up"));
    for (Handle& handle : handles()) handle.at += move;
    return move != glm::dvec2(0);
  }

  Course record() const override {
    Course course;
    Image<Srgb8> paper(world().columns(), world().rows(), {20, 20, 26, 255});
    const auto fix = [&](const Track& track) { track.draw(track.steps(), paper); };
    for (const auto& [from, to] : fixed_) fix(line(glm::ivec2(from), glm::ivec2(to)));
    course.papers.push_back(std::move(paper));
    course.tracks.push_back(line(pixel(0), pixel(1), theme::kAccent));
    course.guides.push_back({corner(0), corner(1)});
    course.remarks.push_back(
        fmt::format("{} fixed (white).",
                    fixed_.size() == 1 ? "1 line is" : fmt::format("{} lines are", fixed_.size())));
    return course;
  }
  Track line(glm::ivec2 from, glm::ivec2 to, Srgb8 ink = theme::kText) const {
    return knob(0).index() == 0 ? dda_track(from, to, world(), 0, ink)
                                : bresenham_track(from, to, world(), 0, ink);
  }

  std::vector<std::pair<glm::dvec2, glm::dvec2>> fixed_;
  bool rubber_ = false;
};

}  // namespace

DemoInfo practical_4_demo() {
  return {"practical-4",
          "Practicals",
          "A rubber-band line: drag, fix with the right button, move with the arrow keys",
          [](const DemoSetup& setup) { return std::make_unique<RubberBand>(setup); },
          1,
          "left: stretch, right: fix",
          {"practical 4"}};
}

}  // namespace kinescope
