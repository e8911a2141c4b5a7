#include "demos/test_card.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "demos/ui/canvas.h"

namespace kinescope {
namespace {

constexpr Srgb8 kGround{74, 78, 86, 255}, kGrid{188, 192, 198, 255}, kWhite{245, 245, 245, 255};
constexpr std::array kBars = {Srgb8{235, 235, 235, 255}, Srgb8{235, 235, 16, 255},
                              Srgb8{16, 235, 235, 255},  Srgb8{16, 235, 16, 255},
                              Srgb8{235, 16, 235, 255},  Srgb8{235, 16, 16, 255},
                              Srgb8{16, 16, 235, 255},   Srgb8{16, 16, 16, 255}};

void draw_grid(Canvas& canvas, float width, float height, float cell, float line) {
  for (float x = std::fmod(width * 0.5f, cell); x < width; x += cell) {
    canvas.fill({std::round(x), 0, line, height}, kGrid);
  }
  for (float y = std::fmod(height * 0.5f, cell); y < height; y += cell) {
    canvas.fill({0, std::round(y), width, line}, kGrid);
  }
  canvas.frame({0, 0, width, height}, line * 2, kWhite);
}

void draw_bars(Canvas& canvas, const Rect& room) {
  const float bar = room.width / static_cast<float>(kBars.size());
  for (std::size_t i = 0; i < kBars.size(); ++i) {
    const float x0 = std::round(room.x + bar * static_cast<float>(i));
    const float x1 = std::round(room.x + bar * static_cast<float>(i + 1));
    canvas.fill({x0, room.y, x1 - x0, room.height}, kBars[i]);
  }
}

void draw_greys(Canvas& canvas, const Rect& room) {
  constexpr int kSteps = 11;
  const float step = room.width / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const auto grey = static_cast<std::uint8_t>(std::lround(255.0 * i / (kSteps - 1)));
    const float x0 = std::round(room.x + step * static_cast<float>(i));
    const float x1 = std::round(room.x + step * static_cast<float>(i + 1));
    canvas.fill({x0, room.y, x1 - x0, room.height}, {grey, grey, grey, 255});
  }
}

/// Gratings of one, two, three pixels and so on: what the spot still resolves.
void draw_gratings(Canvas& canvas, const Rect& room) {
  float x = room.x;
  for (float width = 1; x + width < room.right(); width += 1) {
    for (int i = 0; i < 6 && x + width < room.right(); ++i, x += 2 * width) {
      canvas.fill({x, room.y, width, room.height}, kWhite);
    }
    x += 4;
  }
}

void ring(Canvas& canvas, glm::vec2 centre, float radius, float width) {
  canvas.frame({centre.x - radius, centre.y - radius, 2 * radius, 2 * radius}, width, kWhite,
               radius);
}

}  // namespace

Image<Srgb8> test_card(const Studio& studio, int width_px, int height_px) {
  Image<Srgb8> card(width_px, height_px, kGround);
  Canvas canvas(card);
  const auto width = static_cast<float>(width_px), height = static_cast<float>(height_px);
  const float unit = std::round(height / 12), line = std::max(1.0f, std::round(height / 300));
  draw_grid(canvas, width, height, unit, line);
  const glm::vec2 centre(std::round(width * 0.5f), std::round(height * 0.5f));
  const Rect middle{centre.x - 5 * unit, centre.y - 3 * unit, 10 * unit, 6 * unit};
  draw_bars(canvas, {middle.x, middle.y, middle.width, 3 * unit});
  draw_greys(canvas, {middle.x, middle.y + 4 * unit, middle.width, unit});
  canvas.fill({middle.x, middle.y + 3 * unit, middle.width, unit}, {16, 16, 16, 255});
  canvas.fill({middle.x, middle.y + 5 * unit, middle.width, unit}, {16, 16, 16, 255});
  draw_gratings(canvas, Rect{middle.x, middle.y + 5 * unit, middle.width, unit}.shrunk(line * 3));
  if (height_px >= 200) {
    canvas.text(studio.sans, {centre.x, middle.y + 3.72f * unit},
                fmt::format("KINESCOPE   {} x {}", width_px, height_px), unit * 0.62f, kWhite,
                Align::kCentre);
  }
  ring(canvas, centre, 5.5f * unit, 2 * line);
  for (const float x : {1.5f * unit, width - 1.5f * unit}) {
    for (const float y : {1.5f * unit, height - 1.5f * unit}) ring(canvas, {x, y}, unit, line);
  }
  return card;
}

}  // namespace kinescope
