// Iterated function systems by the chaos game: one random map after another draws the attractor.
#include <fmt/format.h>

#include "demos/lesson/chart.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/ifs.h"

namespace kinescope {
namespace {

enum { kSystem, kShare, kSeed };
enum { kTriangle, kFern };

constexpr int kMoves = 12'000;

class IteratedFunctions : public ClonableDemo<IteratedFunctions, Lesson> {
 public:
  explicit IteratedFunctions(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each move goes part of the way to a corner drawn by lot, or takes "
                         "one of the fern's maps: its colour tells which. Drag the corners.",
             .handles = {{"a", {0.5, 0.08}}, {"b", {0.1, 0.9}}, {"c", {0.9, 0.9}}},
             .resolution = 7,
             .speed = 6},
            {choice_knob("system", {"1", "2"}, {"triangle", "fern"}, kTriangle,
                         "three corners, or Barnsley's four maps"),
             number_knob("share", "3", "4", 0.3, 0.8, 0.05, 0.5, "", "of the way to the corner"),
             number_knob("game", "5", "6", 1, 20, 1, 1, "", "another run of chance")}) {}

 private:
  bool handle_in(int, int) const override { return knob(kSystem).index() == kTriangle; }

  /// Of the three corners, in pixels: p' = (1 - share) p + share corner.
  Ifs corner_maps() const {
    const double share = knob(kShare).value, rest = 1 - share;
    Ifs ifs;
    for (int i = 0; i < 3; ++i) {
      pixel(i);
      ifs.push_back({{rest, 0, 0, rest, share * corner(i).x, share * corner(i).y}, 1});
    }
    return ifs;
  }

  /// Where each map puts a frame about the whole.
  void guide_copies(Course& course, const Ifs& ifs, const std::array<glm::dvec2, 4>& frame,
                    const FittedFigure* fitted) const {
    for (std::size_t m = 0; m < ifs.size(); ++m) {
      std::vector<glm::dvec2> corners;
      for (std::size_t i = 0; i <= 4; ++i) {
        const glm::dvec2 p = ifs[m].map * glm::dvec3(frame[i % 4], 1);
        corners.push_back(fitted ? fitted->place(world(), p) : p);
      }
      guide_chain(course, corners, theme::with_alpha(kChartInks[m + 1], 140));
    }
  }

  Course record() const override {
    const bool fern = knob(kSystem).index() == kFern;
    const Ifs ifs = fern ? fern_ifs() : corner_maps();
    FittedFigure figure;
    figure.hold({-2.2, 0});
    figure.hold({2.7, 10});
    Course course;
    if (fern) {
      guide_copies(course, ifs, {{{-2.2, 0}, {2.7, 0}, {2.7, 10}, {-2.2, 10}}}, &figure);
    } else {
      guide_copies(course, ifs, {corner(0), corner(1), corner(2), corner(2)}, nullptr);
    }
    Track track("chaos game", {"x", "y", "map"});
    ChaosGame game(ifs, static_cast<std::uint64_t>(knob(kSeed).value));
    for (int i = 0; i < kMoves; ++i) {
      const glm::dvec2 p = game.next();
      ink_point(track, world(), fern ? figure.place(world(), p) : p, kChartInks[game.taken + 1]);
      track.step({p.x, p.y, double(game.taken + 1)});
    }
    course.tracks.push_back(std::move(track));
    if (fern) {
      for (std::size_t m = 0; m < ifs.size(); ++m) {
        course.remarks.push_back(
            fmt::format("map {} is taken {:.0f} times of 100", m + 1, 100 * ifs[m].share));
      }
    } else {
      const double ratio = 1 - knob(kShare).value;
      course.remarks = {fmt::format("three copies, each {:.2f} times as large", ratio),
                        ratio > 0.5 ? "that overlap"
                                    : fmt::format("dimension log 3 / log {:.3g} = {:.3f}",
                                                  1 / ratio, similarity_dimension(3, ratio))};
    }
    return course;
  }
};

}  // namespace

DemoInfo iterated_functions_demo() {
  return {"iterated-functions",
          "9 Curves and fractals",
          "Sierpinski's triangle and Barnsley's fern by the chaos game",
          [](const DemoSetup& setup) { return std::make_unique<IteratedFunctions>(setup); },
          1,
          "drag the corners",
          {"IFS (fern)", "fractal dimension by similarity"}};
}

}  // namespace kinescope
