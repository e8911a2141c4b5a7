// Light at the vertices, spread over the triangle by interpolation (H. Gouraud, "Continuous shading
// of curved surfaces", IEEE Transactions on Computers, 1971).
#include "shading/models/models.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/models/gouraud.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "shading/kernels/finish-inl.h"
#include "shading/kernels/illuminate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

void shade_gouraud(const Batch& batch, LinearRgba* out) {
  const Surface& surface = *static_cast<const Surface*>(batch.constants);
  const Finish finish(batch, surface, lit_row::kTexcoord, out);
  const std::array body = three_arrays(batch, lit_row::kBody);
  const std::array highlight = three_arrays(batch, lit_row::kHighlight);
  const Vec3 none = splat(glm::vec3(0.0f));
  const bool apart = keeps_highlight_apart(surface);
  const int step = static_cast<int>(hn::Lanes(Floats()));
  for (int i = 0; i < batch.size; i += step) {
    finish(i, load(body, i), apart ? load(highlight, i) : none);
  }
}

/// Rows turned into arrays, lit, and turned back, a block at a time. Rows are moved by four floats:
/// (position, n.x), (n.y, n.z, u, v) and (colour, -) become (body, h.r) and (h.g, h.b, u, v), the
/// latter only where the highlight is kept apart.
class VertexBlock {
 public:
  static constexpr int kSize = 64;

  VertexBlock(const Surface& surface, int stride) : surface_(surface), stride_(stride) {
    for (std::size_t k = 0; k < 3; ++k) {
      points_.position[k] = in_[vertex_row::kPosition + k];
      points_.normal[k] = in_[vertex_row::kNormal + k];
      if (surface.vertex_colours) points_.colour[k] = in_[vertex_row::kColour + k];
    }
  }

  void light(const float* rows, int count, float* lit_rows) {
    for (int quad = 0; 4 * quad < stride_; ++quad) load_quad(rows + 4 * quad, count, quad);
    if (keeps_highlight_apart(surface_)) {
      light_apart(count, lit_rows);
    } else {
      light_together(count, lit_rows);
    }
  }

 private:
  void light_together(int count, float* lit_rows) {
    const Floats d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    illuminate</*kHalfVector=*/false>(surface_, points_, count,
                                      [&](int i, Vec3 body, Vec3 highlight) HWY_ATTR {
                                        body = add(body, highlight);
                                        const bool whole = i + lanes <= count;
                                        hn::StoreInterleaved4(body.x, body.y, body.z, hn::Zero(d),
                                                              d, whole ? lit_rows + 4 * i : first_);
                                        if (!whole)
                                          std::copy_n(first_, 4 * (count - i), lit_rows + 4 * i);
                                      });
  }

  void light_apart(int count, float* lit_rows) {
    illuminate</*kHalfVector=*/false>(
        surface_, points_, count, [&](int i, Vec3 body, Vec3 highlight) HWY_ATTR {
          const Floats d;
          const Vec u = hn::Load(d, in_[vertex_row::kTexcoord] + i);
          const Vec v = hn::Load(d, in_[vertex_row::kTexcoord + 1] + i);
          hn::StoreInterleaved4(body.x, body.y, body.z, highlight.x, d, first_ + 4 * i);
          hn::StoreInterleaved4(highlight.y, highlight.z, u, v, d, second_ + 4 * i);
        });
    for (int i = 0; i < count; ++i, lit_rows += lit_row::kMaxSize) {
      std::copy_n(first_ + 4 * i, 4, lit_rows);
      std::copy_n(second_ + 4 * i, 4, lit_rows + 4);
    }
  }

  void load_quad(const float* rows, int count, int quad) {
    const Floats d;
    for (int i = 0; i < count; ++i, rows += stride_) std::copy_n(rows, 4, first_ + 4 * i);
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
      Vec a, b, c, e;
      hn::LoadInterleaved4(d, first_ + 4 * i, a, b, c, e);
      hn::Store(a, d, in_[4 * quad] + i);
      hn::Store(b, d, in_[4 * quad + 1] + i);
      hn::Store(c, d, in_[4 * quad + 2] + i);
      hn::Store(e, d, in_[4 * quad + 3] + i);
    }
  }

  const Surface& surface_;
  int stride_;
  PointArrays points_;
  // Lanes past the last vertex are computed and dropped.
  alignas(64) float in_[vertex_row::kStrideWithColour][kSize] = {};
  alignas(64) float first_[4 * kSize] = {};
  alignas(64) float second_[4 * kSize] = {};
};

void light_vertices(const Surface& surface, std::span<const float> rows,
                    std::span<float> lit_rows) {
  const int stride = surface.vertex_colours ? vertex_row::kStrideWithColour : vertex_row::kStride;
  const std::size_t count = rows.size() / static_cast<std::size_t>(stride);
  const auto lit_size = static_cast<std::size_t>(lit_row_size(surface));
  assert(lit_rows.size() >= count * lit_size);
  VertexBlock block(surface, stride);
  for (std::size_t i = 0; i < count; i += VertexBlock::kSize) {
    const std::size_t size = std::min<std::size_t>(VertexBlock::kSize, count - i);
    block.light(rows.data() + i * static_cast<std::size_t>(stride), static_cast<int>(size),
                lit_rows.data() + i * lit_size);
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
