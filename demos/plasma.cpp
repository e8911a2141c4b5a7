// Plasma, clouds, flames and a landscape by the diamond-square algorithm, half a generation a step.
#include "engine/fractals/plasma.h"

#include <fmt/format.h>

#include <bit>

#include "demos/height_palettes.h"
#include "demos/lesson/lesson.h"

namespace kinescope {
namespace {

enum { kHurst, kPalette, kSeed };

class Plasma : public ClonableDemo<Plasma, Lesson> {
 public:
  explicit Plasma(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Squares get a centre, then diamonds; each is its neighbours' mean, "
                         "displaced less and less. 1 and 2: rough or smooth. y: colours.",
             .resolution = 7,
             .speed = 1},
            {number_knob("Hurst", "1", "2", 0, 1, 0.1, 0.8, "", "1 is smooth, 0 is rough"),
             choice_knob("colours", {"y"}, {"plasma", "clouds", "flames", "map"},
                         static_cast<int>(HeightPalette::kMap), "of the heights"),
             number_knob("place", "3", "4", 1, 20, 1, 3, "", "another run of chance")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }
  HeightPalette palette() const { return HeightPalette{knob(kPalette).index()}; }

  void draw_heights(Track& track, const DiamondSquare& made) const {
    const int side = made.field.side;
    const glm::ivec2 corner((world().columns() - side) / 2, (world().rows() - side) / 2);
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const glm::ivec2 p = made.nearest_made(i, j);
        track.plot(corner.x + i, corner.y + j, height_colour(palette(), made.field.at(p.x, p.y)));
      }
    }
  }

  /// Seen from the south and above: columns of the picture from the front to the back, each pixel
  /// once.
  void draw_landscape(Track& track, const DiamondSquare& made) const {
    const int width = world().columns(), rows = world().rows();
    const double last = made.field.side - 1, relief = 0.09 * rows;
    for (int x = 0; x < width; ++x) {
      const double east = last * x / (width - 1);
      int top = rows;  // drawn from here on down
      const auto fill = [&](int up_to, Srgb8 colour) {
        for (; top > std::max(0, up_to); --top) track.plot(x, top - 1, colour);
      };
      for (int south = static_cast<int>(last); south >= 0; --south) {
        const double height = made.height_between(east, south);
        const double west = made.height_between(std::max(0.0, east - 1), south);
        const bool sea = palette() == HeightPalette::kMap && height < 0;
        const double y = rows * (0.8 - 0.45 * (last - south) / last) - (sea ? 0 : relief * height);
        const double light = sea ? 1 : std::clamp(0.85 + 1.5 * (height - west), 0.45, 1.0);
        const Srgb8 c = height_colour(palette(), height);
        const auto lit = [&](int v) { return static_cast<std::uint8_t>(v * light); };
        if (top == rows) fill(static_cast<int>(y) + 1, kUnlit);  // in front of it
        fill(static_cast<int>(y), {lit(c.r), lit(c.g), lit(c.b), 255});
      }
      fill(0, {10, 14, 30, 255});
    }
  }

  Course record() const override {
    const int room = std::max(2, std::min(world().columns(), world().rows()) - 1);
    const int levels = std::bit_width(static_cast<unsigned>(room)) - 1;
    DiamondSquare made(levels, knob(kHurst).value, static_cast<std::uint64_t>(knob(kSeed).value));
    Track heights("heights", {"stride", "made"}), landscape("landscape", {}, 1);
    do {
      const double across = double(made.field.side - 1) / made.stride;
      draw_heights(heights, made);
      heights.step({double(made.stride),
                    (across + 1) * (across + 1) + (made.diamonds_next ? across * across : 0)});
      if (!made.diamonds_next) draw_landscape(landscape, made);
      landscape.step({});
    } while (made.next());
    Course course;
    course.remarks = {
        fmt::format("place {}: {}x{} heights", knob(kSeed).value, made.field.side, made.field.side),
        fmt::format("dimension 3 - {:.1f} = {:.1f}", knob(kHurst).value, 3 - knob(kHurst).value)};
    course.tracks = {std::move(heights), std::move(landscape)};
    return course;
  }
};

}  // namespace

DemoInfo plasma_demo() {
  return {
      "plasma",
      "9 Curves and fractals",
      "Plasma, clouds, flames and a landscape by displacing midpoints, half a generation a step",
      [](const DemoSetup& setup) { return std::make_unique<Plasma>(setup); },
      1,
      {},
      {"plasma and midpoint-displacement landscapes", "clouds, flames"}};
}

}  // namespace kinescope
