// The scalar reference of texture lookup. shading/texture_lookup.cpp does the same steps in the
// same order, so that the two differ only by the logarithm in the level of detail.
#include <algorithm>
#include <cmath>

#include "shading/texture.h"

namespace kinescope {
namespace {

/// A coordinate brought into [0, 1] by its wrap mode; 0 if it is not finite.
float wrapped(float u, Wrap wrap) {
  if (wrap == Wrap::kRepeat) u = u - std::floor(u);
  if (wrap == Wrap::kMirror) u = std::abs(u - 2.0f * std::floor(u * 0.5f + 0.5f));
  return u >= 0.0f ? std::min(u, 1.0f) : 0.0f;
}

int nearest(float u, int size) {
  return static_cast<int>(std::min(u * static_cast<float>(size), static_cast<float>(size - 1)));
}

struct Neighbours {
  int first = 0;
  float fraction = 0.0f;  ///< the weight of the texel after `first`
};

/// Texel centres lie at (i + 0.5) / size. The neighbour of a repeating edge lies in the padding;
/// at any other edge it has no weight.
Neighbours neighbours(float u, int size, Wrap wrap) {
  const float last = static_cast<float>(size - 1);
  float x = u * static_cast<float>(size) - 0.5f;
  if (wrap == Wrap::kRepeat) {
    if (x < 0.0f) x = x + static_cast<float>(size);
  } else {
    x = std::min(std::max(x, 0.0f), last);
  }
  const float first = std::min(std::floor(x), last);
  return {static_cast<int>(first), x - first};
}

float mix(float a, float b, float t) { return a + (b - a) * t; }

/// Channels still scaled by 65535.
LinearRgba mix(LinearRgba a, LinearRgba b, float t) {
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t), mix(a.a, b.a, t)};
}

LinearRgba widened(const Texel& t) {
  return {static_cast<float>(t.r), static_cast<float>(t.g), static_cast<float>(t.b),
          static_cast<float>(t.a)};
}

LinearRgba bilinear(const Texture::Level& level, float u, float v, const Texture& texture) {
  const Neighbours x = neighbours(u, level.width(), texture.wrap_u);
  const Neighbours y = neighbours(v, level.height(), texture.wrap_v);
  const Texel* top = level.row(y.first) + x.first;
  const Texel* bottom = top + level.stride();
  const LinearRgba left = mix(widened(top[0]), widened(bottom[0]), y.fraction);
  const LinearRgba right = mix(widened(top[1]), widened(bottom[1]), y.fraction);
  return mix(left, right, x.fraction);
}

LinearRgba normalized(LinearRgba c) {
  constexpr float kScale = 1.0f / 65535.0f;
  return {c.r * kScale, c.g * kScale, c.b * kScale, c.a * kScale};
}

}  // namespace

LinearRgba Texture::sample(float u, float v, float lod) const {
  if (levels() == 0) return {1.0f, 1.0f, 1.0f, 1.0f};
  u = wrapped(u, wrap_u);
  v = wrapped(v, wrap_v);
  if (filter == Filter::kNearest) {
    const Level picture = view(0);
    return normalized(
        widened(picture.at(nearest(u, picture.width()), nearest(v, picture.height()))));
  }
  if (filter == Filter::kBilinear) return normalized(bilinear(view(0), u, v, *this));
  const float last = static_cast<float>(levels() - 1);
  lod = lod >= 0.0f ? std::min(lod, last) : 0.0f;
  const float floor = std::floor(lod);
  const int fine = static_cast<int>(floor);
  const int coarse = std::min(fine + 1, levels() - 1);
  return normalized(
      mix(bilinear(view(fine), u, v, *this), bilinear(view(coarse), u, v, *this), lod - floor));
}

float level_of_detail(const Texture& texture, float du_dx, float dv_dx, float du_dy, float dv_dy) {
  if (texture.levels() == 0) return 0.0f;
  const float width = static_cast<float>(texture.view(0).width());
  const float height = static_cast<float>(texture.view(0).height());
  const float right = std::hypot(du_dx * width, dv_dx * height);
  const float down = std::hypot(du_dy * width, dv_dy * height);
  return std::log2(std::max(right, down));
}

}  // namespace kinescope
