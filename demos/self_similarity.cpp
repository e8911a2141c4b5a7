// Magnification, step by step: a curve that is its own part exactly, a set that holds copies of
// itself, and a line that only keeps its manner.
#include <fmt/format.h>

#include "demos/lesson/chart.h"
#include "engine/fractals/brownian.h"
#include "engine/fractals/escape_time.h"
#include "engine/fractals/turtle.h"
#include "engine/transform/exact_angle.h"

namespace kinescope {
namespace {

enum { kKind, kHurst };
enum { kExact, kQuasi, kStatistical };

constexpr std::array kMagnifications = {9, 6, 9};  // further in, the small set is all there is
constexpr std::array kFactors = {3, 2, 2};         // of a step
constexpr int kMost = 300;                         // iterations

class SelfSimilarity : public ClonableDemo<SelfSimilarity, Lesson> {
 public:
  explicit SelfSimilarity(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each step magnifies what the frame holds. Koch's curve comes back "
                         "the same, the set nearly so and far in, the line in kind alone.",
             .resolution = 7,
             .speed = 1},
            {choice_knob("figure", {"1", "2", "3"}, {"exact", "quasi", "statistical"}, kExact,
                         "Koch's curve, the Mandelbrot set, or displaced midpoints"),
             number_knob("Hurst", "4", "5", 0.2, 0.9, 0.1, 0.5, "",
                         "of the line: heights are magnified by 2 to its power")}) {}

 private:
  glm::ivec2 panes() const override { return {1, 2}; }

  /// Koch's curve from its left end, as deep as the magnification lets one see.
  void koch(Track& track, int step) const {
    const double scale = 0.9 * world().columns(), zoom = std::pow(3.0, step);
    const auto place = [&](const glm::dvec2& p) {
      return glm::dvec2(0.05 * world().columns() + scale * zoom * p.x,
                        0.85 * world().rows() - scale * zoom * p.y);
    };
    // Of the whole, only the copy at the left end and the beginning of the next are seen.
    const double size = std::pow(3.0, -step);
    const auto [s, c] = sine_cosine_deg(60);
    draw_l_system(l_system_preset("koch"), 5, [&](const glm::dvec2& a, const glm::dvec2& b) {
      ink_line(track, world(), place(size * a), place(size * b), theme::kText);
      const auto next = [&](const glm::dvec2& p) {
        return place(size * glm::dvec2(1 + c * p.x - s * p.y, s * p.x + c * p.y));
      };
      if (step > 0) ink_line(track, world(), next(a), next(b), theme::kDim);
    });
  }

  void mandelbrot(Track& track, int step) const {
    EscapeView view;
    view.centre = {-1.7548776662466927, 0};  // a small copy's middle
    view.width = world().columns();
    view.height = world().rows();
    view.step = 2.6 / view.width / std::exp2(step);
    view.most = kMost;
    const std::vector<std::int32_t> times = escape_times(view, studio().workers);
    for (int j = 0, k = 0; j < view.height; ++j) {
      for (int i = 0; i < view.width; ++i, ++k) {
        const int time = times[static_cast<std::size_t>(k)];
        const auto light = static_cast<std::uint8_t>(std::min(255.0, 60 * std::log1p(time)));
        track.plot(i, j,
                   time >= kMost ? Srgb8{0, 0, 0, 255}
                                 : Srgb8{static_cast<std::uint8_t>(light / 2), light, 255, 255});
      }
    }
  }

  void motion(Track& track, int step) const {
    const double hurst = knob(kHurst).value;
    MidpointLine line(hurst, 7);
    for (int level = 0; level < 8 + step; ++level) line.next();
    const std::vector<double>& heights = line.heights;
    // 257 points about the middle: finer lines hold the coarser ones' points.
    const std::size_t middle = heights.size() / 2;
    const double gain = 0.12 * world().rows() * std::exp2(hurst * step);
    InkPen pen(theme::kText);
    for (std::size_t i = 0; i <= 256; ++i) {
      const double h = heights[middle - 128 + i] - heights[middle];
      pen.to(track, world(),
             {world().columns() * double(i) / 256, 0.5 * world().rows() - gain * h});
    }
  }

  /// What is magnified, in the whole.
  void frame(Track& whole, double share) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const bool koch = knob(kKind).index() == kExact;
    const glm::dvec2 fixed = koch ? size * glm::dvec2(0.05, 0.85) : 0.5 * size;
    const glm::dvec2 low = fixed - share * fixed, high = low + share * size;
    const glm::dvec2 b(high.x, low.y), d(low.x, high.y);
    for (const auto& [from, to] : {std::pair(low, b), {b, high}, {high, d}, {d, low}}) {
      ink_line(whole, world(), from, to, theme::kAccent);
    }
  }

  void paint(Track& track, int step) const {
    for (int y = 0; y < world().rows(); ++y) {  // wipes what was there
      track.span({y, 0, world().columns()}, kUnlit);
    }
    if (knob(kKind).index() == kExact) koch(track, step);
    if (knob(kKind).index() == kQuasi) mandelbrot(track, step);
    if (knob(kKind).index() == kStatistical) motion(track, step);
  }

  Course record() const override {
    const int kind = knob(kKind).index();
    const double factor = kFactors[static_cast<std::size_t>(kind)];
    Track whole("whole", {}, 0), part("magnified", {"magnified"}, 1);
    paint(whole, 0);
    for (int step = 0; step < kMagnifications[static_cast<std::size_t>(kind)]; ++step) {
      if (step > 0) frame(whole, std::pow(factor, -step));
      whole.step({});
      paint(part, step);
      part.step({std::pow(factor, step)});
    }
    Course course;
    course.tracks = {std::move(whole), std::move(part)};
    constexpr std::array kSays = {"three times as large is the same again",
                                  "a copy appears, with other surroundings",
                                  "another line, as rough as before"};
    course.remarks = {kSays[static_cast<std::size_t>(kind)]};
    if (kind == kStatistical) {
      course.remarks.push_back(fmt::format("heights by 2 to the power {:.1f}", knob(kHurst).value));
    }
    return course;
  }
};

}  // namespace

DemoInfo self_similarity_demo() {
  return {"self-similarity",
          "9 Curves and fractals",
          "Exact, quasi- and statistical self-similarity, magnified step by step",
          [](const DemoSetup& setup) { return std::make_unique<SelfSimilarity>(setup); },
          1,
          {},
          {"exact, quasi- and statistical self-similarity under magnification"}};
}

}  // namespace kinescope
