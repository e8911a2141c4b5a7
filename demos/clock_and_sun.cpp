#include "demos/clock_and_sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "demos/lesson/ink_lines.h"
#include "engine/transform/transform2d.h"
#include "raster/fill/round_fill.h"
#include "raster/scan/thick_area.h"

namespace kinescope {
namespace {

constexpr double kSunriseHour = 6;

/// A line from the middle, its angle clockwise from the top.
void hand(Image<Srgb8>& paper, const World& world, double turns, double from, double to,
          double width, Srgb8 colour) {
  const glm::dvec2 middle = 0.5 * glm::dvec2(world.columns(), world.rows());
  const glm::dvec2 up = apply(rotation_deg(360 * turns), glm::dvec2(0, -1));
  const double radius = 0.46 * world.rows();
  thick_line_area(middle + from * radius * up, middle + to * radius * up, width * radius,
                  world.window(), [&](const RowSpan& span) {
                    std::fill_n(paper.row(span.y) + span.x_begin, span.length(), colour);
                  });
}

void disc(Image<Srgb8>& paper, const glm::dvec2& centre, double radius, Srgb8 colour) {
  PaperInk ink{paper};
  filled_circle(glm::ivec2(glm::floor(centre)), static_cast<int>(radius), [&](const RowSpan& span) {
    for (int x = span.x_begin; x < span.x_end; ++x) ink.plot(x, span.y, colour);
  });
}

Srgb8 between(Srgb8 a, Srgb8 b, double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  const auto mix = [&](int from, int to) {
    return static_cast<std::uint8_t>(std::lround(from + s * (to - from)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

}  // namespace

void paint_clock(Image<Srgb8>& paper, const World& world, double time) {
  const glm::dvec2 middle = 0.5 * glm::dvec2(world.columns(), world.rows());
  disc(paper, middle, 0.48 * world.rows(), theme::kKeyCap);
  disc(paper, middle, 0.46 * world.rows(), {20, 26, 40, 255});
  for (int mark = 0; mark < 60; ++mark) {
    const bool hour = mark % 5 == 0;
    hand(paper, world, mark / 60.0, hour ? 0.86 : 0.93, 0.97, hour ? 0.035 : 0.012,
         hour ? theme::kText : theme::kDim);
  }
  hand(paper, world, time / 43200, -0.1, 0.55, 0.06, theme::kAccent);
  hand(paper, world, time / 3600, -0.12, 0.82, 0.04, theme::kText);
  hand(paper, world, time / 60, -0.2, 0.9, 0.015, theme::kRed);
  disc(paper, middle, 0.03 * world.rows(), theme::kRed);
}

double sun_height(double time) {
  return std::sin((time / 3600 - kSunriseHour) / 12 * std::numbers::pi);
}

void paint_sun(Image<Srgb8>& paper, const World& world, double time, double noon_deg) {
  const double height = sun_height(time), columns = world.columns(), rows = world.rows();
  const double horizon = 0.8 * rows;
  const Srgb8 zenith = between({4, 6, 18, 255}, {40, 110, 200, 255}, 0.35 + 1.3 * height);
  const Srgb8 low = height < 0.3
                        ? between({10, 12, 30, 255}, {255, 120, 50, 255}, 1 + 3.3 * height)
                        : between({255, 120, 50, 255}, {170, 210, 240, 255}, 3 * height - 0.9);
  for (int y = 0; y < world.rows(); ++y) {
    std::fill_n(paper.row(y), world.columns(), between(zenith, low, y / horizon));
  }
  std::mt19937 random(11);  // stars, as long as the sky is dark
  for (int i = 0; i < 60 && height < -0.1; ++i) {
    const int x = static_cast<int>(random() % unsigned(world.columns()));
    const int y = static_cast<int>(random() % unsigned(horizon));
    paper.at(x, y) = theme::kText;
  }
  const glm::dvec2 sun(columns * ((time / 3600 - kSunriseHour) / 12 * 0.8 + 0.1),
                       horizon - 0.72 * rows * height * noon_deg / 90);
  const double radius = 0.07 * rows;
  PaperInk ink{paper};
  for (int ray = 0; ray < 12 && height > -0.2; ++ray) {
    const glm::dvec2 way = apply(rotation_deg(30 * ray + time / 40), glm::dvec2(1, 0));
    ink_line(ink, world, sun + 1.3 * radius * way, sun + 2 * radius * way, theme::kAccent);
  }
  if (height > -0.5) disc(paper, sun, radius, {255, 220, 110, 255});
  const Srgb8 ground = between({8, 14, 10, 255}, {50, 110, 50, 255}, 0.2 + height);
  for (int x = 0; x < world.columns(); ++x) {
    const double hill = 0.05 * rows * std::sin(7 * x / columns) * std::sin(3 * x / columns + 1);
    for (int y = std::max(0, static_cast<int>(horizon - hill)); y < world.rows(); ++y) {
      paper.at(x, y) = ground;
    }
  }
}

}  // namespace kinescope
