// The grids by which geometry and convergence are set.
#include <vector>

#include "display/patterns/areas.h"
#include "display/patterns/patterns.h"

namespace kinescope {
namespace {

constexpr int kAcross = 16, kDown = 12;  // squares of a 4:3 face

/// Where `count` cells begin and the last ends, the first at 0, the last `thickness` before the
/// end.
std::vector<int> grid_lines(int count, int size, int thickness) {
  std::vector<int> lines;
  for (int i = 0; i <= count; ++i) {
    lines.push_back(static_cast<int>(std::lround(1.0 * i * std::max(0, size - thickness) / count)));
  }
  return lines;
}

}  // namespace

Image<Srgb8> crosshatch(int width, int height) {
  const Srgb8 white = grey_drive(1);
  Image<Srgb8> picture(width, height);
  for (const int y : grid_lines(kDown, height, 1)) fill_rect(picture, {0, y, width, 1}, white);
  for (const int x : grid_lines(kAcross, width, 1)) fill_rect(picture, {x, 0, 1, height}, white);
  return picture;
}

Image<Srgb8> convergence_dots(int width, int height) {
  constexpr int kSide = 2;
  Image<Srgb8> picture(width, height);
  for (const int top : grid_lines(kDown, height, kSide)) {
    for (const int left : grid_lines(kAcross, width, kSide)) {
      fill_rect(picture, {left, top, kSide, kSide}, grey_drive(1));
    }
  }
  return picture;
}

}  // namespace kinescope
