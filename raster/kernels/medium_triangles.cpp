#include "raster/kernels/medium_triangles.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/medium_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;

/// Several triangles, set up at once, each to be drawn alone.
struct SetUp {
  static constexpr std::size_t kLanes = 8;
  template <typename T>
  using Lanes = std::array<T, kLanes>;

  /// E (raw units squared, with the top-left bias) at the corner of the box's first pixel; sides.
  alignas(32) std::array<Lanes<std::int32_t>, 3> e, dx, dy;
  alignas(32) Lanes<std::int32_t> x0, y0, x1, y1;  // pixels within the tile, half open
  alignas(32) Lanes<float> anchor_x, anchor_y, z, dz_dx, dz_dy, nearest, farthest;
};

HWY_INLINE void store_edge(VI xa, VI ya, VI xb, VI yb, VI corner_x, VI corner_y, std::size_t edge,
                           SetUp& out) {
  const I i;
  const VI dx = hn::Sub(xb, xa), dy = hn::Sub(yb, ya), zero = hn::Zero(i);
  const auto top_left = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
  const VI e = hn::Sub(hn::Mul(dx, hn::Sub(corner_y, ya)), hn::Mul(dy, hn::Sub(corner_x, xa)));
  hn::Store(hn::Sub(e, hn::IfThenZeroElse(top_left, hn::Set(i, 1))), i, out.e[edge].data());
  hn::Store(dx, i, out.dx[edge].data());
  hn::Store(dy, i, out.dy[edge].data());
}

/// The same operations as set_up_triangle's, in its order.
HWY_INLINE void store_depth(const MediumChunk& t, std::size_t k, VI x1, VI y1, VI x2, VI y2,
                            SetUp& out) {
  const F f;
  const VF z0 = hn::LoadU(f, t.z[0].data() + k);
  const VF z1 = hn::LoadU(f, t.z[1].data() + k);
  const VF z2 = hn::LoadU(f, t.z[2].data() + k);
  const VF z10 = hn::Sub(z1, z0), z20 = hn::Sub(z2, z0);
  const VI area = hn::Sub(hn::Mul(x1, y2), hn::Mul(x2, y1));
  const VF inverse = hn::Div(hn::Set(f, 1.0f), hn::ConvertTo(f, area));
  const VF num_x = hn::Sub(hn::Mul(z10, hn::ConvertTo(f, y2)), hn::Mul(z20, hn::ConvertTo(f, y1)));
  const VF num_y = hn::Sub(hn::Mul(z20, hn::ConvertTo(f, x1)), hn::Mul(z10, hn::ConvertTo(f, x2)));
  const VF to_pixels = hn::Set(f, 256.0f);
  hn::Store(z0, f, out.z.data());
  hn::Store(hn::Mul(hn::Mul(num_x, inverse), to_pixels), f, out.dz_dx.data());
  hn::Store(hn::Mul(hn::Mul(num_y, inverse), to_pixels), f, out.dz_dy.data());
  hn::Store(hn::Min(hn::Min(z0, z1), z2), f, out.nearest.data());
  hn::Store(hn::Max(hn::Max(z0, z1), z2), f, out.farthest.data());
}

HWY_INLINE void set_up(const MediumChunk& t, std::size_t k, const PixelRect& rect, SetUp& out) {
  const F f;
  const I i;
  const VI x0 = hn::LoadU(i, t.x[0].data() + k), y0 = hn::LoadU(i, t.y[0].data() + k);
  const VI x1 = hn::LoadU(i, t.x[1].data() + k), y1 = hn::LoadU(i, t.y[1].data() + k);
  const VI x2 = hn::LoadU(i, t.x[2].data() + k), y2 = hn::LoadU(i, t.y[2].data() + k);
  // The pixels that the box touches, whatever the samples' places in them.
  const auto first = [&](VI a, VI b, VI c, int least) HWY_ATTR {
    return hn::Max(hn::ShiftRight<8>(hn::Min(hn::Min(a, b), c)), hn::Set(i, least));
  };
  const auto end = [&](VI a, VI b, VI c, int most) HWY_ATTR {
    return hn::Min(hn::Add(hn::ShiftRight<8>(hn::Max(hn::Max(a, b), c)), hn::Set(i, 1)),
                   hn::Set(i, most));
  };
  const VI box_x = first(x0, x1, x2, rect.x0), box_y = first(y0, y1, y2, rect.y0);
  hn::Store(box_x, i, out.x0.data());
  hn::Store(box_y, i, out.y0.data());
  hn::Store(end(x0, x1, x2, rect.x1), i, out.x1.data());
  hn::Store(end(y0, y1, y2, rect.y1), i, out.y1.data());
  const VI corner_x = hn::ShiftLeft<8>(box_x), corner_y = hn::ShiftLeft<8>(box_y);
  store_edge(x0, y0, x1, y1, corner_x, corner_y, 0, out);
  store_edge(x1, y1, x2, y2, corner_x, corner_y, 1, out);
  store_edge(x2, y2, x0, y0, corner_x, corner_y, 2, out);
  const VF to_px = hn::Set(f, 1.0f / 256.0f);
  hn::Store(hn::Mul(hn::ConvertTo(f, x0), to_px), f, out.anchor_x.data());
  hn::Store(hn::Mul(hn::ConvertTo(f, y0), to_px), f, out.anchor_y.data());
  store_depth(t, k, hn::Sub(x1, x0), hn::Sub(y1, y0), hn::Sub(x2, x0), hn::Sub(y2, y0), out);
}

/// One edge along a row of eight pixels: E / 256 rounded down, whose sign is exact.
struct EdgeRow {
  VI value, step_y;
};

HWY_INLINE EdgeRow edge_row(const SetUp& t, std::size_t edge, std::size_t k, SampleOffset sample,
                            int columns_before) {
  const I i;
  const std::int32_t dx = t.dx[edge][k], dy = t.dy[edge][k];
  const std::int32_t e = (t.e[edge][k] + dx * sample.y.raw() - dy * sample.x.raw()) >> 8;
  const VI columns = hn::Iota(i, -columns_before);
  return {hn::Sub(hn::Set(i, e), hn::Mul(columns, hn::Set(i, dy))), hn::Set(i, dx)};
}

/// One triangle of the group, one sample, in columns of a vector's width.
HWY_INLINE void draw_one(const SetUp& t, std::size_t k, std::uint32_t id, SampleOffset sample,
                         const PixelRect& rect, int stride, float* plane_z,
                         std::uint32_t* plane_id) {
  const F f;
  const I i;
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const int x0 = t.x0[k], y0 = t.y0[k], x1 = t.x1[k], y1 = t.y1[k];
  const VF one = hn::Set(f, 1.0f), anchor_y = hn::Set(f, t.anchor_y[k]);
  const VF z0 = hn::Set(f, t.z[k]), dz_dy = hn::Set(f, t.dz_dy[k]), dz_dx = hn::Set(f, t.dz_dx[k]);
  const VF nearest = hn::Set(f, t.nearest[k]), farthest = hn::Set(f, t.farthest[k]);
  const auto ids = hn::Set(u, id);
  const VI minus_one = hn::Set(i, -1);
  for (int x = x0 & -lanes; x < x1; x += lanes) {
    EdgeRow a = edge_row(t, 0, k, sample, x0 - x), b = edge_row(t, 1, k, sample, x0 - x),
            c = edge_row(t, 2, k, sample, x0 - x);
    const VF px = hn::Add(hn::ConvertTo(f, hn::Iota(i, x)), hn::Set(f, sample.x.to_float()));
    const VF column_z = hn::Mul(dz_dx, hn::Sub(px, hn::Set(f, t.anchor_x[k])));
    // Exact: rows are below 2^15 and samples lie in sixteenths.
    VF py = hn::Set(f, static_cast<float>(y0) + sample.y.to_float());
    std::size_t at = static_cast<std::size_t>((y0 - rect.y0) * stride + x - rect.x0);
    for (int y = y0; y < y1; ++y, at += static_cast<std::size_t>(stride)) {
      const auto covered = hn::Gt(hn::Or(hn::Or(a.value, b.value), c.value), minus_one);
      if (!hn::AllFalse(i, covered)) {
        const VF row_z = hn::Add(z0, hn::Mul(dz_dy, hn::Sub(py, anchor_y)));
        const VF z = hn::Min(hn::Max(hn::Add(row_z, column_z), nearest), farthest);
        const VF old_z = hn::Load(f, plane_z + at);
        const auto old_id = hn::Load(u, plane_id + at);
        const auto earlier = hn::RebindMask(f, hn::Lt(ids, old_id));
        const auto wins = hn::And(hn::RebindMask(f, covered),
                                  hn::Or(hn::Lt(z, old_z), hn::And(hn::Eq(z, old_z), earlier)));
        hn::Store(hn::IfThenElse(wins, z, old_z), f, plane_z + at);
        hn::Store(hn::IfThenElse(hn::RebindMask(u, wins), ids, old_id), u, plane_id + at);
      }
      a.value = hn::Add(a.value, a.step_y);
      b.value = hn::Add(b.value, b.step_y);
      c.value = hn::Add(c.value, c.step_y);
      py = hn::Add(py, one);
    }
  }
}

void DrawMediumTriangles(const ChunkList<MediumChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  const I i;
  const auto lanes = static_cast<std::size_t>(hn::Lanes(i));
  SetUp group;
  for (const MediumChunk* chunk = triangles.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t first = 0; first < size; first += lanes) {
      set_up(*chunk, first, tile.rect, group);
      const std::size_t count = std::min(lanes, size - first);
      for (std::size_t s = 0; s < pattern.size(); ++s) {
        const std::size_t plane = s * static_cast<std::size_t>(tile.plane);
        for (std::size_t k = 0; k < count; ++k) {
          if (group.nearest[k] > tile.farthest) continue;
          draw_one(group, k, chunk->id[first + k], pattern[s], tile.rect, tile.stride,
                   tile.depth.data() + plane, tile.id.data() + plane);
        }
      }
    }
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawMediumTriangles);

void draw_medium_triangles(const ChunkList<MediumChunk>& triangles,
                           std::span<const SampleOffset> pattern, TileBuffer& tile) {
  if (triangles.first == nullptr) return;
  HWY_DYNAMIC_DISPATCH(DrawMediumTriangles)(triangles, pattern, tile);
}

}  // namespace kinescope
#endif
