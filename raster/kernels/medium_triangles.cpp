#include "raster/kernels/medium_triangles.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/medium_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/sample_lanes-inl.h"
#include "raster/kernels/set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
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

HWY_INLINE void set_up(const MediumChunk& t, std::size_t k, const PixelRect& rect, SetUp& out) {
  const F f;
  const I i;
  const Corners c = load_corners(t, k);
  // The pixels that the box touches, whatever the samples' places in them.
  const VI box_x = hn::Max(hn::ShiftRight<8>(least(c.x)), hn::Set(i, rect.x0));
  const VI box_y = hn::Max(hn::ShiftRight<8>(least(c.y)), hn::Set(i, rect.y0));
  const VI one = hn::Set(i, 1);
  const VI end_x = hn::Min(hn::Add(hn::ShiftRight<8>(most(c.x)), one), hn::Set(i, rect.x1));
  const VI end_y = hn::Min(hn::Add(hn::ShiftRight<8>(most(c.y)), one), hn::Set(i, rect.y1));
  hn::Store(box_x, i, out.x0.data());
  hn::Store(box_y, i, out.y0.data());
  hn::Store(end_x, i, out.x1.data());
  hn::Store(end_y, i, out.y1.data());
  const VI corner_x = hn::ShiftLeft<8>(box_x), corner_y = hn::ShiftLeft<8>(box_y);
  for (int v = 0; v < 3; ++v) {
    const Edge edge = edge_at(c, v, corner_x, corner_y);
    const auto at = static_cast<std::size_t>(v);
    hn::Store(edge.e, i, out.e[at].data());
    hn::Store(edge.dx, i, out.dx[at].data());
    hn::Store(edge.dy, i, out.dy[at].data());
  }
  const DepthPlanes depth = depth_planes(t, k, c);
  hn::Store(depth.x_px, f, out.anchor_x.data());
  hn::Store(depth.y_px, f, out.anchor_y.data());
  hn::Store(depth.z, f, out.z.data());
  hn::Store(depth.dz_dx, f, out.dz_dx.data());
  hn::Store(depth.dz_dy, f, out.dz_dy.data());
  hn::Store(depth.nearest, f, out.nearest.data());
  hn::Store(depth.farthest, f, out.farthest.data());
}

/// One edge down a column of vectors: E / 256 rounded down, whose sign is exact.
struct EdgeColumn {
  VI value, step_x, step_y;
};

/// @param x  pixel of the vector's first lane
template <class Lanes>
HWY_INLINE EdgeColumn edge_column(const SetUp& t, std::size_t edge, std::size_t k,
                                  const Lanes& lanes, int x) {
  const I i;
  const VI dx = hn::Set(i, t.dx[edge][k]), dy = hn::Set(i, t.dy[edge][k]);
  const VI shift = hn::Sub(hn::Mul(dx, lanes.raw_y), hn::Mul(dy, lanes.raw_x));
  const VI e = hn::ShiftRight<8>(hn::Add(hn::Set(i, t.e[edge][k]), shift));
  const VI columns = hn::Add(lanes.column, hn::Set(i, x - t.x0[k]));
  return {hn::Sub(e, hn::Mul(columns, dy)), hn::Set(i, Lanes::kPixels * t.dy[edge][k]), dx};
}

/// One triangle of the group, in columns of a vector's width.
template <class Lanes>
HWY_INLINE void draw_one(const SetUp& t, std::size_t k, std::uint32_t id, const Lanes& lanes,
                         TileBuffer& tile) {
  const F f;
  const I i;
  const U u;
  const int x0 = t.x0[k], y0 = t.y0[k], x1 = t.x1[k], y1 = t.y1[k];
  const VF one = hn::Set(f, 1.0f), anchor_y = hn::Set(f, t.anchor_y[k]);
  const VF z0 = hn::Set(f, t.z[k]), dz_dy = hn::Set(f, t.dz_dy[k]), dz_dx = hn::Set(f, t.dz_dx[k]);
  const VF nearest = hn::Set(f, t.nearest[k]), farthest = hn::Set(f, t.farthest[k]);
  const auto ids = hn::Set(u, id);
  const VI minus_one = hn::Set(i, -1);
  float* const plane_z = tile.depth.data();
  std::uint32_t* const plane_id = tile.id.data();
  const int first = x0 & -Lanes::kPixels;
  EdgeColumn edge[3];
  for (std::size_t e = 0; e < 3; ++e) edge[e] = edge_column(t, e, k, lanes, first);
  const auto stride = static_cast<std::size_t>(tile.stride * Lanes::kSamples);
  for (int x = first; x < x1; x += Lanes::kPixels) {
    VI a = edge[0].value, b = edge[1].value, c = edge[2].value;
    const VF px = hn::Add(hn::ConvertTo(f, hn::Add(lanes.column, hn::Set(i, x))), lanes.x_px);
    const VF column_z = hn::Mul(dz_dx, hn::Sub(px, hn::Set(f, t.anchor_x[k])));
    // Exact: rows are below 2^15 and samples lie in sixteenths.
    VF py = hn::Add(hn::Set(f, static_cast<float>(y0)), lanes.y_px);
    std::size_t at = lanes.place(tile, x, y0);
    for (int y = y0; y < y1; ++y, at += stride) {
      const auto covered = hn::Gt(hn::Or(hn::Or(a, b), c), minus_one);
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
      a = hn::Add(a, edge[0].step_y);
      b = hn::Add(b, edge[1].step_y);
      c = hn::Add(c, edge[2].step_y);
      py = hn::Add(py, one);
    }
    for (EdgeColumn& e : edge) e.value = hn::Sub(e.value, e.step_x);
  }
}

template <int kSamples>
HWY_INLINE void draw_all(const ChunkList<MediumChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  const I i;
  const auto lanes = static_cast<std::size_t>(hn::Lanes(i));
  SetUp group;
  for (const MediumChunk* chunk = triangles.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t first = 0; first < size; first += lanes) {
      set_up(*chunk, first, tile.rect, group);
      const std::size_t count = std::min(lanes, size - first);
      for (int part = 0; part < Lanes::kParts; ++part) {
        const Lanes samples(pattern, part);
        for (std::size_t k = 0; k < count; ++k) {
          if (group.nearest[k] > tile.farthest) continue;
          draw_one(group, k, chunk->id[first + k], samples, tile);
        }
      }
    }
  }
}

void DrawMediumTriangles(const ChunkList<MediumChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  switch (pattern.size()) {
    case 1:
      return draw_all<1>(triangles, pattern, tile);
    case 4:
      return draw_all<4>(triangles, pattern, tile);
    default:
      return draw_all<8>(triangles, pattern, tile);
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
