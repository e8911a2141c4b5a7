// Light at the vertices, spread over the triangle by interpolation (H. Gouraud, "Continuous shading
// of curved surfaces", IEEE Transactions on Computers, 1971).
#include "shading/models/models.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/models/gouraud.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include <algorithm>
#include <cassert>

#include "shading/kernels/finish-inl.h"
#include "shading/kernels/illuminate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

void shade_gouraud(const Batch& batch, LinearRgba* out) {
  const Surface& surface = *static_cast<const Surface*>(batch.constants);
  const Finish finish(batch, surface, lit_row::kTexcoord, out);
  const auto three = [&batch](int first) {
    const auto i = static_cast<std::size_t>(first);
    return std::array{batch.attribute[i], batch.attribute[i + 1], batch.attribute[i + 2]};
  };
  const std::array body = three(lit_row::kBody);
  const std::array highlight = three(lit_row::kHighlight);
  const int step = static_cast<int>(hn::Lanes(Floats()));
  for (int i = 0; i < batch.size; i += step) finish(i, load(body, i), load(highlight, i));
}

/// Rows turned into arrays, and lit, a block at a time.
class VertexBlock {
 public:
  VertexBlock(const Surface& surface, int stride) : surface_(surface), stride_(stride) {
    for (std::size_t k = 0; k < 3; ++k) {
      points_.position[k] = in_[vertex_row::kPosition + k];
      points_.normal[k] = in_[vertex_row::kNormal + k];
      if (surface.vertex_colours) points_.colour[k] = in_[vertex_row::kColour + k];
    }
  }

  void light(const float* rows, int count, float* lit_rows) {
    const int used = surface_.vertex_colours ? vertex_row::kCountWithColour : vertex_row::kTexcoord;
    for (int i = 0; i < kSize; ++i) {
      const float* row = rows + std::min(i, count - 1) * stride_;
      for (int k = 0; k < used; ++k) in_[k][i] = row[k];
    }
    const Floats d;
    illuminate</*kHalfVector=*/false>(surface_, points_, count,
                                      [&](int i, const Vec3& body, const Vec3& highlight) HWY_ATTR {
                                        hn::Store(body.x, d, out_[0] + i);
                                        hn::Store(body.y, d, out_[1] + i);
                                        hn::Store(body.z, d, out_[2] + i);
                                        hn::Store(highlight.x, d, out_[3] + i);
                                        hn::Store(highlight.y, d, out_[4] + i);
                                        hn::Store(highlight.z, d, out_[5] + i);
                                      });
    for (int i = 0; i < count; ++i) {
      float* lit = lit_rows + i * lit_row::kStride;
      for (int k = 0; k < lit_row::kTexcoord; ++k) lit[k] = out_[k][i];
      std::copy_n(rows + i * stride_ + vertex_row::kTexcoord, 2, lit + lit_row::kTexcoord);
    }
  }

  static constexpr int kSize = 64;

 private:
  const Surface& surface_;
  int stride_;
  PointArrays points_;
  alignas(64) float in_[vertex_row::kCountWithColour][kSize];
  alignas(64) float out_[lit_row::kTexcoord][kSize];
};

void light_vertices(const Surface& surface, std::span<const float> rows,
                    std::span<float> lit_rows) {
  const int stride = surface.vertex_colours ? vertex_row::kStrideWithColour : vertex_row::kStride;
  const std::size_t count = rows.size() / static_cast<std::size_t>(stride);
  assert(lit_rows.size() >= count * lit_row::kStride);
  VertexBlock block(surface, stride);
  for (std::size_t i = 0; i < count; i += VertexBlock::kSize) {
    const std::size_t size = std::min<std::size_t>(VertexBlock::kSize, count - i);
    block.light(rows.data() + i * static_cast<std::size_t>(stride), static_cast<int>(size),
                lit_rows.data() + i * lit_row::kStride);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(shade_gouraud);
HWY_EXPORT(light_vertices);

ShadeFunction gouraud_shader() { return &HWY_DYNAMIC_DISPATCH(shade_gouraud); }

void light_vertices(const Surface& surface, std::span<const float> rows,
                    std::span<float> lit_rows) {
  HWY_DYNAMIC_DISPATCH(light_vertices)(surface, rows, lit_rows);
}

}  // namespace kinescope
#endif
