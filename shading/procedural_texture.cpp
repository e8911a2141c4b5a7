#include "shading/procedural_texture.h"

#include <cassert>
#include <cstdint>

namespace kinescope {
namespace {

/// The dark cells of a label are this part of its light ones.
constexpr Srgb8 darker(Srgb8 c) {
  const auto part = [](std::uint8_t v) { return static_cast<std::uint8_t>(v * 5 / 8); };
  return {part(c.r), part(c.g), part(c.b), c.a};
}

Srgb8 cell_colour(int column, int row, int cells) {
  const bool left = column < 2, right = column >= cells - 2;
  const bool top = row < 2, bottom = row >= cells - 2;
  Srgb8 colour{225, 225, 225, 255};
  if (top && left) colour = {230, 40, 40, 255};
  if (top && right) colour = {40, 190, 60, 255};
  if (bottom && left) colour = {50, 80, 235, 255};
  if (bottom && right) colour = {240, 215, 40, 255};
  return (column + row) % 2 == 0 ? colour : darker(colour);
}

}  // namespace

Image<Srgb8> labelled_checkerboard(int width, int height, int cells) {
  assert(cells >= 4);
  Image<Srgb8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<int>(std::int64_t{y} * cells / height);
    for (int x = 0; x < width; ++x) {
      const auto column = static_cast<int>(std::int64_t{x} * cells / width);
      picture.at(x, y) = cell_colour(column, row, cells);
    }
  }
  return picture;
}

}  // namespace kinescope
