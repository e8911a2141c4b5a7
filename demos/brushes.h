// What a paint program's hand does to its paper: strokes and figures of a round pen, flooded areas.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "raster/image/image.h"
#include "raster/scan/row_span.h"

namespace kinescope {

inline constexpr Srgb8 kPaintPaper{240, 236, 226, 255};
inline constexpr std::array kPaints = {Srgb8{24, 24, 30, 255},   Srgb8{200, 44, 40, 255},
                                       Srgb8{236, 160, 30, 255}, Srgb8{40, 140, 60, 255},
                                       Srgb8{36, 110, 200, 255}, kPaintPaper};

/// A sink for points and rows.
struct Brush {
  Image<Srgb8>& paper;
  Srgb8 colour;
  void operator()(int x, int y) const {
    if (paper.contains(x, y)) paper.at(x, y) = colour;
  }
  void operator()(const RowSpan& span) const {
    for (int x = span.x_begin; x < span.x_end; ++x) (*this)(x, span.y);
  }
};

/// @param width of the pen, pixels
void paint_line(const Brush& brush, glm::ivec2 from, glm::ivec2 to, int width);
void paint_box(const Brush& brush, glm::ivec2 from, glm::ivec2 to, int width);
void paint_ellipse(const Brush& brush, glm::ivec2 centre, glm::ivec2 radii, int width);

/// What is stretched from one point to another like a rubber band; an ellipse about the first.
enum class BrushFigure { kLine, kBox, kEllipse };
void paint_figure(const Brush& brush, BrushFigure figure, glm::ivec2 from, glm::ivec2 to,
                  int width);

/// A house under the sun, so that there is something to fill.
Image<Srgb8> first_painting(int width, int height);
/// The same with other pixels, each the nearest.
Image<Srgb8> sampled(const Image<Srgb8>& paper, int width, int height);

}  // namespace kinescope
