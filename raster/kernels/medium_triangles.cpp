#include "raster/kernels/medium_triangles.h"

#include <algorithm>
#include <array>
#include <bit>

#include "raster/kernels/cull.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/medium_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/prefetch-inl.h"
#include "raster/kernels/tile_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {

/// Columns of vectors of `pixels` each that a medium triangle may touch.
constexpr std::size_t most_columns(std::size_t pixels) {
  return (CulledTriangles::kMostMediumPx + 2) / pixels + 2;
}

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
  /// Of each column: the rows from y0 where a sample may be covered, half open.
  alignas(32) std::array<Lanes<std::int32_t>, most_columns(1)> first_row, end_row;
};

/// Finds the rows of columns that are `pixels` wide and begin at multiples of it. In a column an
/// edge is greatest at one end, and there linear in the row, so that it bounds the rows on one
/// side.
HWY_INLINE void find_rows(const Edge (&edge)[3], VI x0, VI end_x, VI rows,
                          const SampleLimits& limits, int pixels, SetUp& out) {
  const F f;
  const I i;
  const VI zero = hn::Zero(i);
  const VI begin = hn::And(x0, hn::Set(i, -pixels)), ahead = hn::Sub(x0, begin);
  const auto greater = [&](VI side, Fixed24_8 a, Fixed24_8 b) HWY_ATTR {
    return hn::Max(hn::Mul(side, hn::Set(i, a.raw())), hn::Mul(side, hn::Set(i, b.raw())));
  };
  VF most[3], step[3], inverse[3];
  hn::Mask<F> rises[3];
  HWY_UNROLL(3)
  for (int e = 0; e < 3; ++e) {
    const VI dx = edge[e].dx, dy = edge[e].dy, fall = hn::Neg(dy);
    const VI raw = hn::Add(hn::Add(edge[e].e, greater(dx, limits.least_y, limits.most_y)),
                           greater(fall, limits.least_x, limits.most_x));
    const VI at_end = hn::Mul(hn::Max(fall, zero), hn::Set(i, pixels - 1));
    const VI value = hn::Add(hn::Add(hn::ShiftRight<8>(raw), hn::Mul(ahead, dy)), at_end);
    // Whole numbers: half a unit more changes no sign, and outweighs what is rounded below.
    most[e] = hn::Add(hn::ConvertTo(f, value), hn::Set(f, 0.5f));
    step[e] = hn::ConvertTo(f, hn::Mul(dy, hn::Set(i, pixels)));
    const VF run = hn::ConvertTo(f, dx);
    inverse[e] =
        hn::IfThenElse(hn::Eq(run, hn::Zero(f)), hn::Set(f, -1e9f), hn::Div(hn::Set(f, 1.0f), run));
    rises[e] = hn::Gt(run, hn::Zero(f));
  }
  const VF end = hn::ConvertTo(f, rows), one = hn::Set(f, 1.0f);
  const int width = hn::GetLane(hn::MaxOfLanes(i, hn::Sub(end_x, begin)));
  for (std::size_t c = 0; static_cast<int>(c) * pixels < width; ++c) {
    VF first = hn::Zero(f), last = hn::Sub(end, one);
    HWY_UNROLL(3)
    for (int e = 0; e < 3; ++e) {
      const VF row = hn::Neg(hn::Mul(most[e], inverse[e]));
      first = hn::IfThenElse(rises[e], hn::Max(first, row), first);
      last = hn::IfThenElse(rises[e], last, hn::Min(last, row));
      most[e] = hn::Sub(most[e], step[e]);
    }
    last = hn::Floor(hn::Max(last, hn::Set(f, -1.0f)));
    hn::Store(hn::ConvertTo(i, hn::Ceil(hn::Min(first, end))), i, out.first_row[c].data());
    hn::Store(hn::ConvertTo(i, hn::Add(last, one)), i, out.end_row[c].data());
  }
}

/// @param pixels  columns of a vector
HWY_INLINE void set_up(const TriangleChunk& t, std::size_t k, const SampleLimits& limits,
                       const PixelRect& rect, int pixels, SetUp& out) {
  const F f;
  const I i;
  const Binned binned = load_binned(t, k, rect.x0, rect.y0);
  const Corners& c = binned.at;
  const VI box_x = hn::Max(first_pixel(least(c.x), limits.most_x), hn::Set(i, rect.x0));
  const VI box_y = hn::Max(first_pixel(least(c.y), limits.most_y), hn::Set(i, rect.y0));
  const VI last_x = hn::Min(last_pixel(most(c.x), limits.least_x), hn::Set(i, rect.x1 - 1));
  const VI last_y = hn::Min(last_pixel(most(c.y), limits.least_y), hn::Set(i, rect.y1 - 1));
  const VI one = hn::Set(i, 1), end_x = hn::Add(last_x, one), end_y = hn::Add(last_y, one);
  hn::Store(box_x, i, out.x0.data());
  hn::Store(box_y, i, out.y0.data());
  hn::Store(end_x, i, out.x1.data());
  hn::Store(end_y, i, out.y1.data());
  const VI corner_x = hn::ShiftLeft<8>(box_x), corner_y = hn::ShiftLeft<8>(box_y);
  Edge edge[3];
  HWY_UNROLL(3)
  for (int v = 0; v < 3; ++v) {
    edge[v] = edge_at(c, v, corner_x, corner_y);
    const auto at = static_cast<std::size_t>(v);
    hn::Store(edge[v].e, i, out.e[at].data());
    hn::Store(edge[v].dx, i, out.dx[at].data());
    hn::Store(edge[v].dy, i, out.dy[at].data());
  }
  find_rows(edge, box_x, end_x, hn::Sub(end_y, box_y), limits, pixels, out);
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
  HWY_UNROLL(3)
  for (std::size_t e = 0; e < 3; ++e) {
    edge[e] = edge_column(t, e, k, lanes, first);
    step_x[e] = hn::Set(i, Lanes::kPixels * t.dy[e][k]);
  }
  for (int x = first, c = 0; x < t.x1[k]; x += Lanes::kPixels, ++c) {
    const auto column = static_cast<std::size_t>(c);
    const int y0 = t.first_row[column][k], y1 = t.end_row[column][k];
    if (y0 < y1) {
      EdgeColumn at_row[3];
      HWY_UNROLL(3)
      for (std::size_t e = 0; e < 3; ++e) {
        at_row[e] = {hn::Add(edge[e].value, hn::Set(i, y0 * t.dx[e][k])), edge[e].step_y};
      }
      draw_column(at_row, hn::Zero(i), triangle, lanes, x, t.y0[k] + y0, t.y0[k] + y1, tile);
    }
    HWY_UNROLL(3)
    for (std::size_t e = 0; e < 3; ++e) edge[e].value = hn::Sub(edge[e].value, step_x[e]);
  }
}

/// Whether nothing that lies beyond `nearest` can be seen in some blocks. Source: N. Greene,
/// M. Kass and G. Miller, "Hierarchical Z-buffer visibility", SIGGRAPH 1993, with one level.
template <int kSamples>
HWY_INLINE bool is_hidden(std::uint64_t blocks, float nearest, TileBuffer& tile) {
  constexpr std::uint8_t kEnough = 10;  // triangles drawn, to look at a block anew
  for (std::uint64_t left = blocks; left != 0; left &= left - 1) {
    const int block = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(block);
    if (nearest > tile.block_farthest[at]) continue;
    if (tile.drawn[at] < kEnough) return false;
    tile.drawn[at] = 0;
    tile.block_farthest[at] = farthest_in_block<kSamples>(block, tile);
    if (!(nearest > tile.block_farthest[at])) return false;
  }
  return true;
}

/// Another triangle is drawn into some blocks.
HWY_INLINE void count_drawn(std::uint64_t blocks, TileBuffer& tile) {
  for (std::uint64_t left = blocks; left != 0; left &= left - 1) {
    std::uint8_t& drawn = tile.drawn[static_cast<std::size_t>(std::countr_zero(left))];
    drawn = static_cast<std::uint8_t>(drawn + (drawn < 255 ? 1 : 0));
  }
}

template <int kSamples>
HWY_INLINE void draw_all(const ChunkList<TriangleChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  const I i;
  const auto lanes = static_cast<std::size_t>(hn::Lanes(i));
  const LaneParts<kSamples> parts(pattern);
  const SampleLimits limits = sample_limits(pattern);
  SetUp group;
  for (const TriangleChunk* chunk = triangles.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t first = 0; first < size; first += lanes) {
      prefetch(chunk->next, first / lanes, TriangleChunk::kCapacity / lanes);
      set_up(*chunk, first, limits, tile.rect, Lanes::kPixels, group);
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
