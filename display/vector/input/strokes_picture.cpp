#include "display/vector/input/strokes_picture.h"

#include <algorithm>

#include "display/vector/input/beam_strokes.h"
#include "raster/path/line_painter.h"

namespace kinescope {
namespace {

/// Pixels from device units.
struct Placement {
  float scale;
  glm::vec2 corner;  ///< of the drawing's origin, pixels
  glm::vec2 origin;
  glm::vec2 operator()(float x, float y) const {
    return {corner.x + scale * (x - origin.x), corner.y - scale * (y - origin.y)};
  }
};

Placement placement(const VectorDrawing& drawing, int width, int height) {
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  const float scale = std::min(w / drawing.size.x, h / drawing.size.y);
  return {scale,
          {0.5f * (w - scale * drawing.size.x), 0.5f * (h + scale * drawing.size.y)},
          drawing.origin};
}

}  // namespace

Image<Srgb8> strokes_picture(const VectorDrawing& drawing, int width, int height,
                             Workers& workers) {
  const VectorDrawing strokes = beam_strokes(drawing);
  const Placement place = placement(drawing, width, height);
  Image<LinearRgba> light(width, height);
  LinePainter painter(workers);
  std::vector<InkedLine> lines;
  for_each_run(strokes, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    lines.clear();
    const LinearRgba colour = decode(pen.colour);
    for (std::size_t i = first; i < last; ++i) {
      const VectorSegment& s = strokes.segments[i];
      LinearRgba ink = colour;
      ink.a = std::clamp(s.intensity, 0.0f, 1.0f);
      lines.push_back({{place(s.x1, s.y1), place(s.x2, s.y2)}, ink});
    }
    const Stroke stroke{std::max(1.0f, pen.width * place.scale), Cap::kRound};
    painter.draw(lines, stroke, Mixing::kAdd, light);
  });
  Image<Srgb8> picture(width, height);
  const auto from = light.pixels();
  std::transform(from.begin(), from.end(), picture.pixels().begin(), [](const LinearRgba& c) {
    return encode_srgb8(LinearRgb{c.r, c.g, c.b});
  });
  return picture;
}

}  // namespace kinescope
