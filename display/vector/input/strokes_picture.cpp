#include "display/vector/input/strokes_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "display/vector/beam_painter.h"
#include "display/vector/input/beam_strokes.h"

namespace kinescope {
namespace {

/// The spot's deviation as a share of the picture's longer side: a line is as wide, half way up its
/// flanks, as one of 1024 points. Never less than what a pixel can show without steps.
constexpr float kSigmaShare = 1 / 2.355f / 1024, kLeastSigmaPx = 0.6f;
/// No figure at hand: the 4014's defocused lines are plainly wider.
constexpr float kDefocus = 3;

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

/// Strokes and their light in each of three planes.
struct Beams {
  std::vector<BeamStroke> strokes;
  std::vector<float> weights;

  /// The light of a line of intensity 1 is 1 in its middle, and so is that of a point.
  void add(const BeamStroke& stroke, float intensity, const LinearRgba& colour) {
    const float length = std::hypot(stroke.x1 - stroke.x0, stroke.y1 - stroke.y0);
    const float root = std::sqrt(2 * std::numbers::pi_v<float>);
    const float across = root * stroke.sigma;
    const float weight = intensity * across * std::max(length, across);
    strokes.push_back(stroke);
    for (const float channel : {colour.r, colour.g, colour.b}) weights.push_back(weight * channel);
  }
};

Beams beams_of(const VectorDrawing& strokes, int width, int height) {
  const Placement place = placement(strokes, width, height);
  const float side = static_cast<float>(std::max(width, height));
  const float sharp = std::max(kLeastSigmaPx, kSigmaShare * side);
  Beams beams;
  for_each_run(strokes, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    const LinearRgba colour = decode(pen.colour);
    const float sigma = pen.defocused ? kDefocus * sharp : sharp;
    for (std::size_t i = first; i < last; ++i) {
      const VectorSegment& s = strokes.segments[i];
      const glm::vec2 a = place(s.x1, s.y1), b = place(s.x2, s.y2);
      beams.add({a.x, a.y, b.x, b.y, sigma}, s.intensity, colour);
    }
  });
  return beams;
}

/// A tile of the light, encoded.
void encode(const TiledLight& light, int tile, Image<Srgb8>& picture) {
  const int left = tile % light.columns() * kBeamTile, top = tile / light.columns() * kBeamTile;
  const int right = std::min(left + kBeamTile, light.width());
  const int bottom = std::min(top + kBeamTile, light.height());
  const float *r = light.plane(tile, 0), *g = light.plane(tile, 1), *b = light.plane(tile, 2);
  for (int y = top; y < bottom; ++y) {
    const int row = (y - top) * kBeamTile - left;
    for (int x = left; x < right; ++x) {
      picture.at(x, y) = encode_srgb8(LinearRgb{r[row + x], g[row + x], b[row + x]});
    }
  }
}

}  // namespace

Image<Srgb8> strokes_picture(const VectorDrawing& drawing, int width, int height,
                             Workers& workers) {
  const Beams beams = beams_of(beam_strokes(drawing), width, height);
  TiledLight light(width, height, 3);
  BeamPainter().draw(beams.strokes, beams.weights, light, workers);
  Image<Srgb8> picture(width, height);
  workers.run(light.tiles(), [&](int tile, int) {
    if (light.lit(tile)) encode(light, tile, picture);
  });
  return picture;
}

}  // namespace kinescope
