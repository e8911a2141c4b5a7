// Scenes for the tests of blending: rectangles whose coverage and depth are plain to see, random
// calls of all kinds, and shaders whose colours are exact.
#pragma once

#include <deque>
#include <vector>

#include "raster/rasterizer.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {

inline void shade_given(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) out[i] = *static_cast<const LinearRgba*>(batch.constants);
}

/// A colour of its own for every triangle and pixel, the same however fragments are batched; alpha
/// is sometimes out of range.
inline void shade_by_number_and_pixel(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    const std::uint32_t n = batch.primitive[i] * 2654435761u + batch.x[i] * 97u + batch.y[i] * 31u;
    const auto part = [n](int shift) { return static_cast<float>(n >> shift & 255) / 255.0f; };
    out[i] = {part(0), part(8), part(16), part(24) * 1.2f - 0.1f};
  }
}

inline void shade_attributes(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    out[i] = {batch.attribute[0][i], batch.attribute[1][i], batch.attribute[2][i],
              batch.attribute[3][i]};
  }
}

/// Draw calls and what they look at; never moves its parts.
class BlendScene {
 public:
  /// A rectangle of whole pixels at one depth, in one colour.
  DrawCall& add_rect(const PixelRect& r, float z, LinearRgba colour,
                     BlendMode mode = BlendMode::kAlpha,
                     BlendOrder order = BlendOrder::kSubmitted) {
    const auto x0 = static_cast<float>(r.x0), x1 = static_cast<float>(r.x1);
    const auto y0 = static_cast<float>(r.y0), y1 = static_cast<float>(r.y1);
    TriangleSoup soup;
    soup.add({x0, y0, z}, {x0, y1, z}, {x1, y1, z});
    soup.add({x0, y0, z}, {x1, y1, z}, {x1, y0, z});
    return add(std::move(soup), colour, mode, order);
  }

  DrawCall& add(TriangleSoup soup, LinearRgba colour, BlendMode mode, BlendOrder order) {
    colours_.push_back(colour);
    DrawCall& call = add(std::move(soup), shade_given, mode, order);
    call.constants = &colours_.back();
    return call;
  }

  DrawCall& add(TriangleSoup soup, ShadeFunction shade, BlendMode mode, BlendOrder order) {
    soups_.push_back(std::move(soup));
    DrawCall call = soups_.back().call(shade);
    call.blend = mode;
    call.order = order;
    calls.push_back(call);
    return calls.back();
  }

  std::vector<DrawCall> calls;

 private:
  std::deque<TriangleSoup> soups_;
  std::deque<LinearRgba> colours_;
};

/// Calls of every kind over triangles of every size; the first few are plain.
inline BlendScene random_blend_scene(unsigned seed, int width, int height,
                                     ShadeFunction shade = shade_by_number_and_pixel) {
  RandomTriangles random(seed);
  BlendScene scene;
  for (int i = 0; i < 14; ++i) {
    DrawCall& call =
        scene.add(random.soup(10 + random.below(80), width, height), shade, BlendMode::kOpaque,
                  random.below(3) == 0 ? BlendOrder::kByDepth : BlendOrder::kSubmitted);
    if (random.below(3) == 0) {
      call.scissor = PixelRect{random.below(width) - 9, random.below(height) - 9,
                               random.below(width) + 19, random.below(height) + 19};
    }
    if (i < 3) continue;
    call.blend = static_cast<BlendMode>(random.below(4));
    call.depth_test = static_cast<DepthTest>(random.below(8));
    call.depth_write = random.below(2) == 0;
  }
  return scene;
}

struct BlendDrawn {
  Image<LinearRgba> colour;
  Image<float> depth;
  RasterStats stats;
};

inline BlendDrawn draw_blended(const std::vector<DrawCall>& calls, int width, int height,
                               int samples = 1, int threads = 2, RasterizerOptions options = {},
                               LinearRgba clear = {0, 0, 0, 1}) {
  Workers workers(threads);
  Rasterizer rasterizer(workers, options);
  RenderTarget target(width, height, samples, ColourFormat::kLinearFloat);
  target.clear = clear;
  target.keep_depth = true;
  const RasterStats stats = rasterizer.draw(target, calls, true);
  return {std::get<Image<LinearRgba>>(target.colour), target.depth, stats};
}

}  // namespace kinescope
