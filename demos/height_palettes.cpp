#include "demos/height_palettes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kinescope {
namespace {

/// A palette is colours at heights, mixed between them.
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

}  // namespace

Srgb8 height_colour(HeightPalette palette, double height) {
  if (palette == HeightPalette::kClouds) return along(kCloudStops, height);
  if (palette == HeightPalette::kFlames) return along(kFlameStops, height);
  if (palette == HeightPalette::kMap) return along(kMapStops, height);
  const auto channel = [&](double phase) {
    return static_cast<std::uint8_t>(std::lround(127.5 + 127 * std::sin(2.2 * height + phase)));
  };
  return {channel(0), channel(2.1), channel(4.2), 255};
}

}  // namespace kinescope
