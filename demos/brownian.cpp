// Brownian motion: a particle's path, and a line of displaced midpoints of any roughness.
#include "engine/fractals/brownian.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "demos/lesson/chart.h"

namespace kinescope {
namespace {

enum { kHurst, kLevels, kSeed };

constexpr int kWalk = 1500;

class Brownian : public ClonableDemo<Brownian, Lesson> {
 public:
  explicit Brownian(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "The particle is about sqrt(2n) away after n steps. Below: each "
                                  "level halves the line (amber: one level less). 1, 2: roughness.",
                      .resolution = 7,
                      .speed = 5},
                     {number_knob("Hurst", "1", "2", 0.1, 0.9, 0.1, 0.5, "",
                                  "of the line: 0.5 is Brownian motion"),
                      number_knob("levels", "3", "4", 1, 9, 1, 5, "", "how often it was halved"),
                      number_knob("chance", "5", "6", 1, 20, 1, 1, "", "another run of chance")}) {}

 private:
  glm::ivec2 panes() const override { return {1, 2}; }
  std::uint64_t seed() const { return static_cast<std::uint64_t>(knob(kSeed).value); }

  Track path() const {
    std::vector<glm::dvec2> places;
    FittedFigure figure;
    brownian_path(seed(), kWalk, [&](const glm::dvec2& p) {
      places.push_back(p);
      figure.hold(p);
    });
    Track track("path", {"n", "away", "sqrt 2n"});
    InkPen pen(theme::kText);
    for (std::size_t n = 0; n < places.size(); ++n) {
      pen.to(track, world(), figure.place(world(), places[n]));
      track.step({double(n), glm::length(places[n]), std::sqrt(2.0 * double(n))});
    }
    return track;
  }

  /// Drawn from left to right, so that finer lines take longer.
  Track line(const char* name, int levels, const Chart& chart, Srgb8 ink) const {
    MidpointLine midpoints(knob(kHurst).value, seed());
    for (int i = 0; i < levels; ++i) midpoints.next();
    Track track(name, {}, 1, ink);
    InkPen pen(ink);
    const double last = static_cast<double>(midpoints.heights.size() - 1);
    for (std::size_t i = 0; i < midpoints.heights.size(); ++i) {
      pen.to(track, world(), chart.place({double(i) / last, midpoints.heights[i]}));
      track.step({});
    }
    return track;
  }

  Course record() const override {
    const int levels = knob(kLevels).index();
    double low = 0, high = 0;
    MidpointLine scout(knob(kHurst).value, seed());
    for (int i = 0; i < levels; ++i) scout.next();
    for (const double h : scout.heights) low = std::min(low, h), high = std::max(high, h);
    const Chart chart(world(), {0, low}, {1, high});
    Course course;
    chart.axes(course, 1);
    course.tracks = {path(), line("one level less", levels - 1, chart, theme::kAccent),
                     line("displaced midpoints", levels, chart, theme::kCool)};
    course.remarks = {
        "the path's dimension is 2",
        fmt::format("the line: {} points, dimension 2 - {:.1f} = {:.1f}", scout.heights.size(),
                    knob(kHurst).value, 2 - knob(kHurst).value)};
    return course;
  }
};

}  // namespace

DemoInfo brownian_demo() {
  return {"brownian",
          "9 Curves and fractals",
          "Brownian motion, and lines of any roughness by displaced midpoints",
          [](const DemoSetup& setup) { return std::make_unique<Brownian>(setup); },
          1,
          {},
          {"Brownian motion", "fractional Brownian motion"}};
}

}  // namespace kinescope
