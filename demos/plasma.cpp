// Plasma, clouds, flames and a landscape by the diamond-square algorithm, half a generation a step.
#include "engine/fractals/plasma.h"

#include <fmt/format.h>

#include <bit>

#include "demos/lesson/lesson.h"

namespace kinescope {
namespace {

enum { kHurst, kPalette, kSeed };
enum { kPlasma, kClouds, kFlames, kMap };

struct Stop {
  double height;
  Srgb8 colour;
};
constexpr std::array kCloudStops = {Stop{-1.2, {36, 84, 170, 255}}, Stop{0, {110, 160, 220, 255}},
                                    Stop{0.9, {240, 244, 250, 255}}};
constexpr std::array kFlameStops = {Stop{-1.2, {8, 2, 4, 255}}, Stop{-0.2, {150, 16, 4, 255}},
                                    Stop{0.6, {250, 150, 20, 255}},
                                    Stop{1.4, {255, 250, 200, 255}}};
constexpr std::array kMapStops = {Stop{-1.6, {8, 24, 80, 255}},  Stop{-0.01, {60, 130, 200, 255}},
                                  Stop{0, {214, 196, 140, 255}}, Stop{0.15, {70, 140, 60, 255}},
                                  Stop{0.8, {110, 96, 70, 255}}, Stop{1.5, {245, 245, 250, 255}}};

Srgb8 along(std::span<const Stop> stops, double height) {
  std::size_t i = 1;
  while (i + 1 < stops.size() && height > stops[i].height) ++i;
  const Stop &a = stops[i - 1], &b = stops[i];
  const double share = std::clamp((height - a.height) / (b.height - a.height), 0.0, 1.0);
  const auto mix = [&](int p, int q) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(double(p), double(q), share)));
  };
  return {mix(a.colour.r, b.colour.r), mix(a.colour.g, b.colour.g), mix(a.colour.b, b.colour.b),
          255};
}

Srgb8 colour_of(int palette, double height) {
  if (palette == kClouds) return along(kCloudStops, height);
  if (palette == kFlames) return along(kFlameStops, height);
  if (palette == kMap) return along(kMapStops, height);
  const auto channel = [&](double phase) {
    return static_cast<std::uint8_t>(std::lround(127.5 + 127 * std::sin(2.2 * height + phase)));
  };
  return {channel(0), channel(2.1), channel(4.2), 255};
}

/// The place at or nearest to (i, j) whose height is made: corners, and centres of squares between
/// the two halves of a generation.
glm::ivec2 nearest_made(const DiamondSquare& made, int i, int j) {
  const int s = made.stride, half = s / 2;
  const glm::ivec2 corner((i + half) / s * s, (j + half) / s * s);
  if (!made.diamonds_next) return corner;
  const int most = made.field.side - 1 - half;
  const glm::ivec2 centre(std::min(i / s * s + half, most), std::min(j / s * s + half, most));
  const auto away = [&](const glm::ivec2& p) { return std::abs(p.x - i) + std::abs(p.y - j); };
  return away(centre) < away(corner) ? centre : corner;
}

/// Between the corners made, evenly.
double smooth_height(const DiamondSquare& made, double x, double y) {
  const int s = made.stride, most = made.field.side - 1 - s;
  const int i = std::min(static_cast<int>(x) / s * s, most);
  const int j = std::min(static_cast<int>(y) / s * s, most);
  const double u = (x - i) / s, v = (y - j) / s;
  const HeightField& f = made.field;
  return std::lerp(std::lerp(f.at(i, j), f.at(i + s, j), u),
                   std::lerp(f.at(i, j + s), f.at(i + s, j + s), u), v);
}

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
             choice_knob("colours", {"y"}, {"plasma", "clouds", "flames", "map"}, kMap,
                         "of the heights"),
             number_knob("place", "3", "4", 1, 20, 1, 3, "", "another run of chance")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  void draw_heights(Track& track, const DiamondSquare& made) const {
    const int side = made.field.side;
    const glm::ivec2 corner((world().columns() - side) / 2, (world().rows() - side) / 2);
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const glm::ivec2 p = nearest_made(made, i, j);
        track.plot(corner.x + i, corner.y + j,
                   colour_of(knob(kPalette).index(), made.field.at(p.x, p.y)));
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
        const double height = smooth_height(made, east, south);
        const double west = smooth_height(made, std::max(0.0, east - 1), south);
        const bool sea = knob(kPalette).index() == kMap && height < 0;
        const double y = rows * (0.8 - 0.45 * (last - south) / last) - (sea ? 0 : relief * height);
        const double light = sea ? 1 : std::clamp(0.85 + 1.5 * (height - west), 0.45, 1.0);
        const Srgb8 c = colour_of(knob(kPalette).index(), height);
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
