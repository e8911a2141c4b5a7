// Cantor's set, Sierpinski's triangle, carpet and tetrahedron: what is left when the middle goes.
#include "engine/fractals/gasket.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "demos/lesson/chart.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/gasket_view.h"
#include "raster/fill/scanline_fill.h"

namespace kinescope {
namespace {

enum { kFigure, kGenerations, kTurn };
enum { kCantor, kTriangle, kCarpet, kTetrahedron };

struct Law {
  double copies, ratio, left;  ///< of length, area or volume, a generation
};
constexpr std::array kLaws = {Law{2, 1.0 / 3, 2.0 / 3}, Law{3, 0.5, 0.75}, Law{8, 1.0 / 3, 8.0 / 9},
                              Law{4, 0.5, 0.5}};
constexpr std::array kDeepest = {8, 7, 4, 4};  // of the generations that a screen shows

class Gaskets : public ClonableDemo<Gaskets, Lesson> {
 public:
  explicit Gaskets(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each generation takes the middle out of every piece: the pieces "
                         "grow in number, what is left goes to nothing. 1 and 2 change it.",
             .resolution = 7,
             .speed = 5},
            {choice_knob("figure", {"y"}, {"Cantor", "triangle", "carpet", "tetrahedron"},
                         kTriangle, "the whole that is thinned out"),
             number_knob("generations", "1", "2", 0, 7, 1, 4, "", "how often the middle was taken"),
             number_knob("turn", "3", "4", -180, 180, 15, 20, "deg", "of the tetrahedron")}) {}

 private:
  int generations() const {
    const auto figure = static_cast<std::size_t>(knob(kFigure).index());
    return std::min(knob(kGenerations).index(), kDeepest[figure]);
  }

  void fill(Track& track, const Polygon& polygon, Srgb8 ink) const {
    scanline_fill(polygon, FillRule::kNonZero, world().window(),
                  [&](const RowSpan& span) { track.span(span, ink); });
  }

  /// All generations, one below the other.
  void cantor(Track& track) const {
    const double width = world().columns(), row = world().rows() / 10.0;
    double piece = 0;
    for (int n = 0; n <= generations(); ++n) {
      cantor_set(0.05 * width, 0.95 * width, n, [&](double from, double to) {
        for (double y = (n + 0.6) * row; y < (n + 1.2) * row; ++y) {
          ink_line(track, world(), {from, y}, {std::max(from, to - 1), y}, kChartInks[0]);
        }
        track.step({++piece, to - from});
      });
    }
  }

  void triangle(Track& track) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const double height = 0.85 * size.y, half = height / std::sqrt(3.0);
    const glm::dvec2 top(0.5 * size.x, 0.07 * size.y);
    double piece = 0;
    sierpinski_triangle({top, top + glm::dvec2(-half, height), top + glm::dvec2(half, height)},
                        generations(), [&](const Triangle2& t) {
                          fill(track, {{t[0], t[1], t[2]}}, theme::kAccent);
                          track.step({++piece, t[2].x - t[1].x});
                        });
  }

  void carpet(Track& track) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const glm::dvec2 half(0.45 * size.y);
    double piece = 0;
    sierpinski_carpet(0.5 * size - half, 0.5 * size + half, generations(),
                      [&](const glm::dvec2& low, const glm::dvec2& high) {
                        fill(track, {{low, {high.x, low.y}, high, {low.x, high.y}}}, theme::kCool);
                        track.step({++piece, high.x - low.x});
                      });
  }

  void tetrahedron(Track& track) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const auto place = [&](const glm::dvec3& p) {
      return glm::dvec2(0.5 * size.x + 0.5 * size.y * p.x, 0.6 * size.y - 0.5 * size.y * p.y);
    };
    constexpr std::array kInks = {theme::kDim, theme::kAccent, theme::kCool, theme::kGreen};
    double piece = 0;
    for (const Tetrahedron& t : seen_tetrahedra(generations(), knob(kTurn).value, 20)) {
      faces_seen(t, [&](std::size_t face, const Triangle3& corners) {
        fill(track, {{place(corners[0]), place(corners[1]), place(corners[2])}}, kInks[face]);
      });
      track.step({++piece, glm::length(t[1] - t[2])});
    }
  }

  Course record() const override {
    const auto figure = static_cast<std::size_t>(knob(kFigure).index());
    Track track(knob(kFigure).text(), {"piece", "size"});
    if (figure == kCantor) cantor(track);
    if (figure == kTriangle) triangle(track);
    if (figure == kCarpet) carpet(track);
    if (figure == kTetrahedron) tetrahedron(track);
    Course course;
    const Law& law = kLaws[figure];
    const int n = generations();
    course.remarks = {
        fmt::format("{} generations: {:.0f} pieces", n, std::pow(law.copies, n)),
        fmt::format("{:.4f} of the whole is left", std::pow(law.left, n)),
        fmt::format("dimension log {} / log {} = {:.3f}", law.copies, std::round(1 / law.ratio),
                    similarity_dimension(law.copies, law.ratio))};
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo gaskets_demo() {
  return {"gaskets",
          "9 Curves and fractals",
          "Cantor's set and Sierpinski's triangle, carpet and tetrahedron, by generations",
          [](const DemoSetup& setup) { return std::make_unique<Gaskets>(setup); },
          1,
          {},
          {"Cantor set", "Sierpinski triangle and carpet", "Sierpinski tetrahedron in 3-D"}};
}

}  // namespace kinescope
