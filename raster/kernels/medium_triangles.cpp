#include "raster/kernels/medium_triangles.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/medium_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/prefetch-inl.h"
#include "raster/kernels/tile_blocks-inl.h"

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
  alignas(32) Lanes<std::uint32_t> id;
};

HWY_INLINE void set_up(const TriangleChunk& t, std::size_t k, const PixelRect& rect, SetUp& out) {
  const F f;
  const I i;
  const Binned binned = load_binned(t, k, rect.x0, rect.y0);
  const Corners& c = binned.at;
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
  const DepthPlanes depth = depth_planes(c, binned.z[0], binned.z[1], binned.z[2]);
  hn::Store(depth.x_px, f, out.anchor_x.data());
  hn::Store(depth.y_px, f, out.anchor_y.data());
  hn::Store(depth.z, f, out.z.data());
  hn::Store(depth.dz_dx, f, out.dz_dx.data());
  hn::Store(depth.dz_dy, f, out.dz_dy.data());
  hn::Store(depth.nearest, f, out.nearest.data());
  hn::Store(depth.farthest, f, out.farthest.data());
  hn::Store(binned.id, U(), out.id.data());
}

/// @param x  pixel of the vector's first lane
template <class Lanes>
HWY_INLINE EdgeColumn edge_column(const SetUp& t, std::size_t edge, std::size_t k,
                                  const Lanes& lanes, int x) {
  const I i;
  const VI dx = hn::Set(i, t.dx[edge][k]), dy = hn::Set(i, t.dy[edge][k]);
  const VI shift = hn::Sub(hn::Mul(dx, lanes.raw_y), hn::Mul(dy, lanes.raw_x));
  const VI e = hn::ShiftRight<8>(hn::Add(hn::Set(i, t.e[edge][k]), shift));
  const VI columns = hn::Add(lanes.column, hn::Set(i, x - t.x0[k]));
  return {hn::Sub(e, hn::Mul(columns, dy)), dx};
}

/// One triangle of the group, in columns of a vector's width.
template <class Lanes>
HWY_INLINE void draw_one(const SetUp& t, std::size_t k, const Lanes& lanes, TileBuffer& tile) {
  const F f;
  const I i;
  const TriangleVectors triangle = {hn::Set(f, t.anchor_x[k]), hn::Set(f, t.anchor_y[k]),
                                    hn::Set(f, t.z[k]),        hn::Set(f, t.dz_dx[k]),
                                    hn::Set(f, t.dz_dy[k]),    hn::Set(f, t.nearest[k]),
                                    hn::Set(f, t.farthest[k]), hn::Set(U(), t.id[k])};
  const int first = t.x0[k] & -Lanes::kPixels;
  EdgeColumn edge[3];
  VI step_x[3];
  for (std::size_t e = 0; e < 3; ++e) {
    edge[e] = edge_column(t, e, k, lanes, first);
    step_x[e] = hn::Set(i, Lanes::kPixels * t.dy[e][k]);
  }
  for (int x = first; x < t.x1[k]; x += Lanes::kPixels) {
    draw_column(edge, hn::Zero(i), triangle, lanes, x, t.y0[k], t.y1[k], tile);
    for (std::size_t e = 0; e < 3; ++e) edge[e].value = hn::Sub(edge[e].value, step_x[e]);
  }
}

template <int kSamples>
HWY_INLINE void draw_all(const ChunkList<TriangleChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  const I i;
  const auto lanes = static_cast<std::size_t>(hn::Lanes(i));
  const LaneParts<kSamples> parts(pattern);
  SetUp group;
  for (const TriangleChunk* chunk = triangles.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t first = 0; first < size; first += lanes) {
      prefetch(chunk->next, first / lanes, TriangleChunk::kCapacity / lanes);
      set_up(*chunk, first, tile.rect, group);
      for (std::size_t k = 0; k < std::min(lanes, size - first); ++k) {
        if (group.nearest[k] > tile.farthest) continue;
        const PixelRect box = {group.x0[k], group.y0[k], group.x1[k], group.y1[k]};
        if (box.empty()) continue;
        const std::uint64_t blocks = blocks_touched(box, tile);
        if (is_hidden<kSamples>(blocks, group.nearest[k], tile)) continue;
        store_blocks(blocks, parts, tile);
        count_drawn(blocks, tile);
        for (const Lanes& samples : parts.part) {
          draw_one(group, k, samples, tile);
        }
      }
    }
  }
}

void DrawMediumTriangles(const ChunkList<TriangleChunk>& triangles,
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

void draw_medium_triangles(const ChunkList<TriangleChunk>& triangles,
                           std::span<const SampleOffset> pattern, TileBuffer& tile) {
  if (triangles.first == nullptr) return;
  HWY_DYNAMIC_DISPATCH(DrawMediumTriangles)(triangles, pattern, tile);
}

}  // namespace kinescope
#endif
