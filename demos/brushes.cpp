#include "demos/brushes.h"

#include <glm/common.hpp>

#include "raster/fill/flood_fill.h"
#include "raster/scan/midpoint_ellipse.h"
#include "raster/scan/thick_pen.h"

namespace kinescope {

void paint_line(const Brush& brush, glm::ivec2 from, glm::ivec2 to, int width) {
  pen_line(from, to, Pen::round(width), brush);
}

void paint_box(const Brush& brush, glm::ivec2 from, glm::ivec2 to, int width) {
  const std::array<glm::ivec2, 4> corners = {{from, {to.x, from.y}, to, {from.x, to.y}}};
  for (std::size_t i = 0; i < 4; ++i) paint_line(brush, corners[i], corners[(i + 1) % 4], width);
}

void paint_ellipse(const Brush& brush, glm::ivec2 centre, glm::ivec2 radii, int width) {
  for (MidpointEllipse e(radii); e.next();) {
    four_way(centre, e.at(), [&](int x, int y) { paint_line(brush, {x, y}, {x, y}, width); });
  }
}

void paint_figure(const Brush& brush, BrushFigure figure, glm::ivec2 from, glm::ivec2 to,
                  int width) {
  switch (figure) {
    case BrushFigure::kLine:
      return paint_line(brush, from, to, width);
    case BrushFigure::kBox:
      return paint_box(brush, from, to, width);
    case BrushFigure::kEllipse:
      return paint_ellipse(brush, from, glm::abs(to - from), width);
  }
}

Image<Srgb8> first_painting(int w, int h) {
  Image<Srgb8> paper(w, h, kPaintPaper);
  const auto on = [&](std::size_t paint) { return Brush{paper, kPaints[paint]}; };
  paint_line(on(3), {w / 10, h * 3 / 4}, {w * 9 / 10, h * 3 / 4}, 3);
  const std::array<glm::ivec2, 5> house = {{{w / 3, h * 3 / 4},
                                            {w / 3, h / 2},
                                            {w / 2, h / 3},
                                            {w * 2 / 3, h / 2},
                                            {w * 2 / 3, h * 3 / 4}}};
  for (std::size_t i = 1; i < house.size(); ++i) {
    paint_line(on(0), house[i - 1], house[i], 3);
  }
  paint_ellipse(on(2), {w * 5 / 6, h / 6}, {h / 12, h / 12}, 3);
  flood_fill(paper, w * 5 / 6, h / 6, Connectivity::kFour, on(2));
  flood_fill(paper, w / 2, h / 2, Connectivity::kFour, on(1));
  return paper;
}

Image<Srgb8> sampled(const Image<Srgb8>& paper, int width, int height) {
  Image<Srgb8> other(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      other.at(x, y) = paper.at(x * paper.width() / width, y * paper.height() / height);
    }
  }
  return other;
}

}  // namespace kinescope
