// Flood and boundary fill by runs, and the recursive one that fails.
#include <fmt/format.h>

#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/fill/boundary_fill.h"
#include "raster/fill/flood_fill.h"
#include "raster/fill/recursive_fill.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {
namespace {

enum { kMethod, kEightWays, kPainted };
enum { kFlood, kBoundary, kRecursive };
constexpr Srgb8 kPaper{20, 20, 26, 255}, kInk = theme::kCool, kWall = theme::kText;

class SeedFill : public ClonableDemo<SeedFill, Lesson> {
 public:
  explicit SeedFill(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for =
                 "Runs need a short stack; the recursive fill's grows with the area, and "
                 "pixels already painted stop it. Eight ways leak through the diagonal wall.",
             .handles = {{"seed", {0.3, 0.5}}},
             .figures = {{"stack holds", 200, 10, 2000, 10}},
             .resolution = 2},
            {choice_knob("fill", {"1", "2", "3"}, {"flood", "boundary", "recursive"}, kFlood,
                         "which algorithm"),
             toggle_knob("8-connected", "8", false, "corners count as neighbours"),
             toggle_knob("painted before", "p", false,
                         "a strip of the new colour lies in the way")}) {}

 private:
  /// A room, cut by a diagonal wall.
  Image<Srgb8> paper() const {
    const int w = world().columns(), h = world().rows();
    Image<Srgb8> image(w, h, kPaper);
    const auto wall = [&](glm::ivec2 a, glm::ivec2 b) {
      for (BresenhamSteps line(a, b); line.next();) image.at(line.at().x, line.at().y) = kWall;
    };
    const glm::ivec2 low(w / 8, h / 8), high(w * 7 / 8, h * 7 / 8);
    for (const auto& [a, b] : {std::pair(low, glm::ivec2(high.x, low.y)),
                               {low, {low.x, high.y}},
                               {high, {high.x, low.y}},
                               {high, {low.x, high.y}}}) {
      wall(a, b);
    }
    wall({w / 2 - (high.y - low.y) / 2, high.y}, {w / 2 + (high.y - low.y) / 2, low.y});
    for (int x = low.x + 1; knob(kPainted).on() && x < w / 2 - h / 4; ++x) {
      image.at(x, h / 3) = kInk;
    }
    return image;
  }

  Course record() const override {
    const glm::ivec2 seed = pixel(0);
    Course course;
    const Image<Srgb8> image = paper();
    course.papers = {image};
    if (!image.contains(seed.x, seed.y)) {
      throw_bad_input("the seed lies outside the picture: nothing is filled");
    }
    const auto ways = knob(kEightWays).on() ? Connectivity::kEight : Connectivity::kFour;
    const int method = knob(kMethod).index();
    if (method == kRecursive) return recursive(std::move(course), image, seed, ways);
    course.tracks.push_back(method == kFlood
                                ? by_runs(flood_filler(image, seed.x, seed.y, ways))
                                : by_runs(boundary_filler(image, seed.x, seed.y, kWall, ways)));
    return course;
  }

  template <typename Fill>
  Track by_runs(Fill fill) const {
    Track track(knob(kMethod).text() + " fill", {"row", "from", "to", "stack"}, 0, kInk);
    while (fill.next()) {
      const RowSpan& run = fill.span();
      track(run);
      track.step(
          {double(run.y), double(run.x_begin), double(run.x_end), double(fill.stack().size())},
          stack_of(fill.stack()));
    }
    return track;
  }

  /// The ranges that the fill looks at next, the top first.
  static std::string stack_of(std::span<const RowSpan> stack) {
    constexpr std::size_t kMostShown = 6;
    std::string lines = stack.empty() ? "stack: empty" : "stack, next first:";
    for (std::size_t i = 0; i < std::min(stack.size(), kMostShown); ++i) {
      const RowSpan& range = stack[stack.size() - 1 - i];
      lines += fmt::format("\n  row {:3}: {:3} to {:3}", range.y, range.x_begin, range.x_end);
    }
    if (stack.size() > kMostShown) lines += fmt::format("\n  {} more", stack.size() - kMostShown);
    return lines;
  }

  template <typename Calls>
  static std::string calls_of(const Calls& calls) {
    constexpr std::size_t kMostShown = 6;
    std::string lines = "calls, innermost first:";
    for (std::size_t i = 0; i < std::min(calls.size(), kMostShown); ++i) {
      const glm::ivec2 at = calls[calls.size() - 1 - i].at;
      lines += fmt::format("\n  fill({}, {})", at.x, at.y);
    }
    if (calls.size() > kMostShown) lines += fmt::format("\n  {} more", calls.size() - kMostShown);
    return lines;
  }

  Course recursive(Course course, Image<Srgb8> image, glm::ivec2 seed, Connectivity ways) const {
    const int room = whole_figure(0);
    if (room < 1) throw_bad_input("stack holds: at least 1 call");
    Track track("recursive fill", {"x", "y", "depth"}, 0, kInk);
    RecursiveFill<Srgb8> fill(image, seed.x, seed.y, kWall, kInk, ways,
                              static_cast<std::size_t>(room));
    while (fill.next()) {
      track(fill.at().x, fill.at().y);
      track.step({double(fill.at().x), double(fill.at().y), double(fill.calls().size())},
                 calls_of(fill.calls()));
    }
    course.remarks.push_back(fill.overflowed()
                                 ? fmt::format("The stack overflowed: {} calls deep.", room)
                                 : fmt::format("Deepest: {} calls.", fill.deepest()));
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo seed_fill_demo() {
  return {"seed-fill",
          "8 Filling, characters, sampling",
          "Flood and boundary fill by runs, and the recursive fill that fails",
          [](const DemoSetup& setup) { return std::make_unique<SeedFill>(setup); },
          1,
          "drag the seed",
          {"boundary fill", "flood fill", "4- and 8-connected", "span-based: no stack overflows",
           "recursive fill failing on painted pixels and on its stack"}};
}

}  // namespace kinescope
