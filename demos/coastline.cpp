// A coast measured with shrinking rulers and covered with shrinking boxes: its fractal dimension.
#include <fmt/format.h>

#include <set>

#include "demos/covering_plot.h"
#include "demos/lesson/chart.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/generator_curve.h"
#include "engine/fractals/random_koch.h"
#include "engine/fractals/turtle.h"

namespace kinescope {
namespace {

enum { kMethod, kCoast, kSize, kSeed };
enum { kRulers, kBoxes };
enum { kKoch, kRandom };

constexpr int kSizes = 6;
using Points = std::vector<glm::dvec2>;

class Coastline : public ClonableDemo<Coastline, Lesson> {
 public:
  explicit Coastline(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Half the ruler, and the coast grows longer: more than twice as "
                         "many fit. The line's slope below is the dimension. 1, 2: size.",
             .resolution = 7,
             .speed = 3},
            {choice_knob("method", {"r", "x"}, {"rulers", "boxes"}, kRulers,
                         "dividers walked along it, or the boxes it needs"),
             choice_knob("coast", {"c"}, {"Koch", "by chance"}, kKoch,
                         "its bumps on one side, or on either by lot"),
             number_knob("size", "1", "2", 0, kSizes - 1, 1, 1, "",
                         "how often the ruler was halved"),
             number_knob("chance", "3", "4", 1, 20, 1, 5, "", "another coast by chance")}) {}

 private:
  glm::ivec2 panes() const override { return {1, 2}; }

  Points coast() const {
    Points points;
    if (knob(kCoast).index() == kKoch) {
      points.emplace_back(0, 0);
      draw_l_system(l_system_preset("koch"), 5,
                    [&](const glm::dvec2&, const glm::dvec2& to) { points.push_back(to); });
    } else {
      SeededRandom random(static_cast<std::uint64_t>(knob(kSeed).value));
      points = random_koch_curve(5, random);
    }
    FittedFigure figure;
    for (const glm::dvec2& p : points) figure.hold(p);
    for (glm::dvec2& p : points) p = figure.place(world(), p);
    return points;
  }

  double size(int halvings) const { return std::ldexp(0.24 * world().columns(), -halvings); }

  /// All points, near enough for the smallest boxes.
  static Points dense(const Points& coast, double spacing) {
    Points points;
    for (std::size_t i = 0; i + 1 < coast.size(); ++i) {
      points_along(coast[i], coast[i + 1], spacing,
                   [&](const glm::dvec2& p) { points.push_back(p); });
    }
    points.push_back(coast.back());
    return points;
  }

  std::vector<Covering> measured(const Points& coast) const {
    std::vector<Covering> coverings;
    std::vector<double> sizes;
    for (int i = 0; i < kSizes; ++i) sizes.push_back(size(i));
    if (knob(kMethod).index() == kBoxes) return count_boxes(dense(coast, size(kSizes)), sizes);
    for (const double ruler : sizes) coverings.push_back({ruler, walk_coast(coast, ruler).steps});
    return coverings;
  }

  Track walked(const Points& coast, double ruler) const {
    Track track("dividers", {"x", "y", "length"});
    RulerWalk walk = walk_coast(coast, ruler);
    walk.feet.push_back(coast.back());  // the last step is a part
    for (std::size_t i = 0; i + 1 < walk.feet.size(); ++i) {
      const glm::dvec2 from = walk.feet[i], to = walk.feet[i + 1];
      ink_line(track, world(), from, to, theme::kAccent);
      track.step({to.x, to.y, i + 2 < walk.feet.size() ? ruler * double(i + 1) : walk.length});
    }
    return track;
  }

  Track covered(const Points& coast, double box) const {
    Track track("boxes", {"column", "row", "boxes"});
    std::set<std::pair<int, int>> boxes;
    for (const glm::dvec2& p : dense(coast, size(kSizes))) {
      const int i = static_cast<int>(std::floor(p.x / box)),
                j = static_cast<int>(std::floor(p.y / box));
      if (!boxes.insert({i, j}).second) continue;
      const glm::dvec2 low = box * glm::dvec2(i, j), high = low + box;
      for (int y = static_cast<int>(std::ceil(low.y)); y < high.y; ++y) {
        ink_line(track, world(), {std::ceil(low.x), y + 0.5}, {high.x - 0.5, y + 0.5},
                 theme::with_alpha((i + j) % 2 != 0 ? theme::kAccent : theme::kCool, 110));
      }
      track.step({double(i), double(j), double(boxes.size())});
    }
    return track;
  }

  Course record() const override {
    const Points coast = this->coast();
    const std::vector<Covering> coverings = measured(coast);
    const DimensionFit fit = fit_dimension(coverings);
    const Covering& now = coverings[static_cast<std::size_t>(knob(kSize).index())];
    const bool boxes = knob(kMethod).index() == kBoxes;
    Course course;
    Track shore("coast", {});
    InkPen pen(theme::kText);
    for (const glm::dvec2& p : coast) pen.to(shore, world(), p);
    shore.step({});
    course.tracks = {
        std::move(shore),
        covering_plot(course, world(), 1, {coverings, fit.dimension, knob(kSize).index()}),
        boxes ? covered(coast, now.size) : walked(coast, now.size)};
    if (boxes) {
      course.remarks = {fmt::format("boxes of {:.2f} pixels: {:.0f}", now.size, now.count)};
    } else {
      course.remarks = {fmt::format("rulers of {:.2f} pixels: {:.2f}", now.size, now.count),
                        fmt::format("so the coast is {:.1f} long", now.size * now.count)};
    }
    course.remarks.push_back(fmt::format("dimension by all sizes: {:.3f}", fit.dimension));
    course.remarks.push_back("by similarity: log 4 / log 3 = 1.262");
    return course;
  }
};

}  // namespace

DemoInfo coastline_demo() {
  return {"coastline",
          "9 Curves and fractals",
          "A coast measured with shrinking rulers and boxes: its fractal dimension",
          [](const DemoSetup& setup) { return std::make_unique<Coastline>(setup); },
          1,
          {},
          {"a coastline measured with shrinking rulers", "fractal dimension by box counting"}};
}

}  // namespace kinescope
