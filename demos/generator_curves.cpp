// A generator drawn by the user in place of every line of an initiator, generation by generation.
#include "engine/fractals/generator_curve.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "demos/lesson/chart.h"
#include "engine/fractals/dimension.h"
#include "engine/transform/exact_angle.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kInitiator, kGenerations };
enum { kLine, kTriangle, kSquare };

constexpr double kMostLines = 20'000;  // that a viewer may wait for

class GeneratorCurves : public ClonableDemo<GeneratorCurves, Lesson> {
 public:
  explicit GeneratorCurves(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each line below becomes a small copy of the generator above. Drag "
                         "its points. 1 and 2: generations; i: a line, triangle or square.",
             .handles = {{"a", {0.4, 0.8}}, {"b", {0.5, 0.345}}, {"c", {0.6, 0.8}}},
             .resolution = 7,
             .speed = 5},
            {choice_knob("initiator", {"i"}, {"line", "triangle", "square"}, kLine,
                         "what is there before the first generation"),
             number_knob("generations", "1", "2", 0, 7, 1, 4, "",
                         "how often every line was replaced")}) {}

 private:
  glm::ivec2 panes() const override { return {1, 2}; }
  bool handle_in(int, int pane) const override { return pane == 0; }

  /// The generator's fixed ends in the upper pane.
  glm::dvec2 from() const { return end(0.2); }
  glm::dvec2 to() const { return end(0.8); }
  glm::dvec2 end(double share) const {
    return glm::round(glm::dvec2(share * world().columns(), 0.8 * world().rows())) + 0.5;
  }

  /// Between (0, 0) and (1, 0), y upwards.
  std::vector<glm::dvec2> between() const {
    std::vector<glm::dvec2> points;
    const double length = to().x - from().x;
    for (int i = 0; i < 3; ++i) {
      pixel(i);
      const glm::dvec2 off = corner(i) - from();
      points.emplace_back(off.x / length, -off.y / length);
    }
    return points;
  }

  /// Corners of the initiator, the first again at its end; a closed one's outside is on the left.
  std::vector<glm::dvec2> initiator() const {
    const int sides = knob(kInitiator).index() + 2;
    if (sides == 2) return {{0, 0}, {1, 0}};
    std::vector<glm::dvec2> corners;
    for (int i = 0; i <= sides; ++i) {
      const auto [s, c] = sine_cosine_deg(90 - 360.0 * i / sides);
      corners.emplace_back(c, s);
    }
    return corners;
  }

  Course record() const override {
    const std::vector<glm::dvec2> middle = between(), start = initiator();
    const int generations = knob(kGenerations).index();
    const double lines = generator_lines(middle.size(), generations) * double(start.size() - 1);
    if (lines > kMostLines) {
      throw_bad_input(fmt::format("{:.0f} lines are more than {:.0f}", lines, kMostLines));
    }
    Course course;
    course.guides = {{from(), corner(0), theme::kAccent, 0},
                     {corner(0), corner(1), theme::kAccent, 0},
                     {corner(1), corner(2), theme::kAccent, 0},
                     {corner(2), to(), theme::kAccent, 0},
                     {from(), to(), theme::kDim, 0}};
    FittedFigure figure;
    const auto every_line = [&](auto&& sink) {
      for (std::size_t i = 0; i + 1 < start.size(); ++i) {
        generator_curve(middle, start[i], start[i + 1], generations, sink);
      }
    };
    double length = 0, before = 0;
    for (std::size_t i = 0; i + 1 < start.size(); ++i)
      before += glm::distance(start[i], start[i + 1]);
    every_line([&](const glm::dvec2& a, const glm::dvec2& b) {
      figure.hold(a), figure.hold(b);
      length += glm::distance(a, b);
    });
    Track generator("generator", {}, 0, theme::kAccent), track("curve", {"line", "length"}, 1);
    double count = 0;
    every_line([&](const glm::dvec2& a, const glm::dvec2& b) {
      ink_line(track, world(), figure.place(world(), a), figure.place(world(), b));
      track.step({++count, glm::distance(a, b)});
    });
    course.remarks = {
        fmt::format("{:.0f} lines, {:.3f} times as long as before", count, length / before)};
    course.remarks.push_back(dimension(middle));
    course.tracks = {std::move(generator), std::move(track)};
    return course;
  }

  static std::string dimension(const std::vector<glm::dvec2>& middle) {
    const std::array ratios = {glm::length(middle[0]), glm::distance(middle[0], middle[1]),
                               glm::distance(middle[1], middle[2]),
                               glm::distance(middle[2], glm::dvec2(1, 0))};
    const double d = moran_dimension(ratios);
    return std::isfinite(d) ? fmt::format("dimension {:.3f} if no parts overlap", d)
                            : "a part as long as the whole: it has no end";
  }
};

}  // namespace

DemoInfo generator_curves_demo() {
  return {"generator-curves",
          "9 Curves and fractals",
          "A generator dragged by hand in place of every line of an initiator",
          [](const DemoSetup& setup) { return std::make_unique<GeneratorCurves>(setup); },
          1,
          "drag the generator's points",
          {"generator and initiator", "fractal dimension by similarity"}};
}

}  // namespace kinescope
