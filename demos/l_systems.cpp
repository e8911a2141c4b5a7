// L-systems: the string that is rewritten, and the turtle that walks it.
#include <fmt/format.h>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/turtle.h"

namespace kinescope {
namespace {

enum { kSystem, kGenerations };

constexpr std::size_t kLongest = 20'000;  // symbols that a viewer may wait for

std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (const LSystem& system : l_system_presets()) names.push_back(system.name);
  return names;
}

/// The symbols about the one obeyed, which stands in brackets of its own.
std::string excerpt(const std::string& string, std::size_t at) {
  const std::size_t from = at > 12 ? at - 12 : 0;
  return string.substr(from, at - from) + " >" + string[at] + "< " + string.substr(at + 1, 12);
}

class LSystems : public ClonableDemo<LSystems, Lesson> {
 public:
  explicit LSystems(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "The turtle obeys one symbol a step: F and G draw, + and - turn, "
                                  "[ keeps its place and ] returns. 1 and 2 change generations.",
                      .resolution = 6,
                      .speed = 5},
                     {choice_knob("system", {"y"}, system_names(), 0, "axiom and rules"),
                      number_knob("generations", "1", "2", 0, 12, 1, 3, "",
                                  "how often all symbols were rewritten")}) {}

 private:
  Course record() const override {
    const LSystem& system = l_system_presets()[static_cast<std::size_t>(knob(kSystem).index())];
    LSystemGenerations strings(system, kLongest);
    while (strings.generation() < knob(kGenerations).index()) strings.next();
    const std::string& string = strings.string();
    FittedFigure figure;
    figure.hold({0, 0});
    std::size_t lines = 0;
    Turtle scout(string, 1, system.angle_deg, system.start_deg);
    while (scout.next([&](const auto&, const auto&) { ++lines; }))
      figure.hold(scout.state.position);

    Track track(system.name, {"symbol", "heading", "stack"});
    const World pane = world();
    Turtle turtle(string, 1, system.angle_deg, system.start_deg);
    while (turtle.next([&](const glm::dvec2& from, const glm::dvec2& to) {
      ink_line(track, pane, figure.place(pane, from), figure.place(pane, to), theme::kGreen);
    })) {
      track.step({double(turtle.at), turtle.state.heading_deg, double(turtle.stack.size())},
                 excerpt(string, turtle.at - 1));
    }
    Course course;
    course.tracks.push_back(std::move(track));
    course.remarks = {"axiom " + system.axiom};
    for (const auto& [symbol, made] : system.rules) {
      course.remarks.push_back(fmt::format("{} -> {}", symbol, made));
    }
    course.remarks.push_back(fmt::format("{} symbols, {} lines", string.size(), lines));
    return course;
  }
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<LSystems>(setup); }

}  // namespace

DemoInfo l_systems_demo() {
  return {"l-systems",
          "9 Curves and fractals",
          "Strings rewritten by rules, walked by a turtle: Koch, dragon, Sierpinski, plants",
          create,
          1,
          {},
          {"L-systems", "Koch curve and snowflake", "quadratic Koch", "Sierpinski arrowhead",
           "dragon", "plants with brackets"}};
}

DemoInfo practical_9_demo() {
  DemoInfo info = l_systems_demo();
  info.name = "practical-9";
  info.chapter = "Practicals";
  info.summary = "Practical 9: fractals, generation by generation";
  info.topics = {"practical 9"};
  return info;
}

}  // namespace kinescope
