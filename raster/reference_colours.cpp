// The law of blending: every sample of every triangle, one after another.
#include <algorithm>
#include <array>
#include <memory>

#include "raster/reference_coverage.h"
#include "raster/reference_rasterizer.h"

namespace kinescope {
namespace {

/// Weights of the second and third vertex at a point, perspective-correct and kept within the
/// triangle.
std::array<double, 2> weights_at(const DrawCall& call, std::size_t triangle, double x, double y) {
  std::array<double, 3> vx{}, vy{}, inv_w{}, area{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = call.indices[3 * triangle + i];
    vx[i] = Fixed24_8::from_float(call.vertices[v].x_px).to_float();
    vy[i] = Fixed24_8::from_float(call.vertices[v].y_px).to_float();
    inv_w[i] = call.vertices[v].inv_w;
  }
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    area[i] = ((vx[a] - x) * (vy[b] - y) - (vx[b] - x) * (vy[a] - y)) * inv_w[i];
    sum += area[i];
  }
  const double w1 = std::clamp(area[1] / sum, 0.0, 1.0);
  return {w1, std::clamp(area[2] / sum, 0.0, 1.0 - w1)};
}

/// Shades one fragment at its pixel's centre.
class PointShader {
 public:
  LinearRgba operator()(const DrawCall& call, std::size_t triangle, bool front, int x, int y,
                        const LinearRgba& clear) {
    if (call.shade == nullptr) return clear;
    Batch batch;
    batch.size = 1;
    batch.constants = call.constants;
    x_[0] = static_cast<std::uint16_t>(x);
    y_[0] = static_cast<std::uint16_t>(y);
    primitive_[0] = call.source_triangle.empty() ? static_cast<std::uint32_t>(triangle)
                                                 : call.source_triangle[triangle];
    facing_[0] = front ? 1.0f : -1.0f;
    batch.x = x_.data();
    batch.y = y_.data();
    batch.primitive = primitive_.data();
    if (call.cull == CullMode::kNone) batch.facing = facing_.data();
    const auto [w1, w2] = weights_at(call, triangle, x + 0.5, y + 0.5);
    for (std::size_t a = 0; a < static_cast<std::size_t>(call.attribute_count); ++a) {
      const auto corner = [&](std::size_t i) {
        const std::size_t row = call.indices[3 * triangle + i];
        return double{call.attributes[row * static_cast<std::size_t>(call.attribute_stride) + a]};
      };
      attribute_[a][0] = static_cast<float>(corner(0) + w1 * (corner(1) - corner(0)) +
                                            w2 * (corner(2) - corner(0)));
      batch.attribute[a] = attribute_[a].data();
    }
    call.shade(batch, out_.data());
    return out_[0];
  }

 private:
  template <typename T>
  using Lanes = std::array<T, Batch::kMaxSize>;
  alignas(64) Lanes<std::uint16_t> x_{}, y_{};
  alignas(64) Lanes<std::uint32_t> primitive_{};
  alignas(64) Lanes<float> facing_{};
  alignas(64) std::array<Lanes<float>, Batch::kMaxAttributes> attribute_{};
  alignas(64) Lanes<LinearRgba> out_{};
};

/// Counter-clockwise as seen.
bool shows_front(const DrawCall& call, std::size_t triangle) {
  DrawCall fronts = call;
  fronts.cull = CullMode::kBack;
  SnappedTriangle unused;
  return set_up_triangle(fronts, triangle, unused);
}

/// A fragment that waits until all depths are known.
struct Layer {
  std::size_t sample;
  float depth;
  std::size_t submitted;
  BlendMode mode;
  LinearRgba colour;
};

}  // namespace

ReferenceImage draw_reference_colours(int width, int height, int samples,
                                      std::span<const DrawCall> calls, const LinearRgba& clear) {
  const std::span<const SampleOffset> pattern = sample_pattern(samples);
  const TileGrid grid(width, height, 8, 8);
  ReferenceImage out = draw_reference(width, height, samples, calls);
  out.colour.assign(out.depth.size(), clear);
  std::vector<float> depth(out.depth.size(), ReferenceImage::kBeyond);
  std::vector<Layer> layers;
  const auto shader = std::make_unique<PointShader>();
  for (const bool by_depth : {false, true}) {
    for (const DrawCall& call : calls) {
      if ((call.order == BlendOrder::kByDepth) != by_depth) continue;
      for (std::size_t i = 0; i < call.indices.size() / 3; ++i) {
        SnappedTriangle triangle;
        if (!set_up_triangle(call, i, triangle)) continue;
        const bool front = shows_front(call, i);
        for_each_sample(call, triangle, pattern, grid, [&](int x, int y, std::size_t s, float z) {
          const std::size_t at = out.index(x, y, s);
          if (!passes(call.depth_test, z, depth[at])) return;
          const LinearRgba colour = (*shader)(call, i, front, x, y, clear);
          if (by_depth) {
            layers.push_back({at, z, layers.size(), call.blend, colour});
          } else {
            out.colour[at] = blended(call.blend, colour, out.colour[at]);
            if (call.depth_write) depth[at] = z;
          }
        });
      }
    }
  }
  std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) {
    return a.depth != b.depth ? a.depth > b.depth : a.submitted < b.submitted;
  });
  for (const Layer& layer : layers) {
    out.colour[layer.sample] = blended(layer.mode, layer.colour, out.colour[layer.sample]);
  }
  return out;
}

}  // namespace kinescope
