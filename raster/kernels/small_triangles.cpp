#include "raster/kernels/small_triangles.h"

#include <algorithm>
#include <array>
#include <limits>

#include "raster/kernels/cull.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/merge_fragments-inl.h"
#include "raster/kernels/pack-inl.h"
#include "raster/kernels/prefetch-inl.h"
#include "raster/kernels/tile_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {

/// Steps along a box's side: a triangle below kSmallPx touches one pixel more than it is long, and
/// with several samples another.
constexpr int kMaxSteps = CulledTriangles::kSmallPx + 2;

/// Triangles to be drawn together: step (c, r) looks at the pixel that lies so many columns and
/// rows from the first of each triangle's box.
template <int kSamples>
struct Group {
  VI edge[kSamples][3];        ///< E / 256 at each sample of the first pixel; only its sign counts
  VI dx[3], dy[3];             ///< how much it rises a row, and falls a column
  VI columns_left, rows_left;  ///< to the end of the tile
  VF from_x[kSamples], from_y[kSamples];  ///< from the depth planes' anchor to each sample
  VF z, dz_dx, dz_dy, nearest, farthest;
  VU id, pixel;       ///< the first one's place in the tile
  int columns, rows;  ///< of the largest box
  PixelRect box;      ///< of all, within the tile
};

/// Lanes beyond the first `count` become points: they cover nothing, and lie near the others.
HWY_INLINE void make_points_beyond(std::size_t count, Corners& c) {
  const I i;
  const auto there = first_lanes(i, count);
  const VI x = hn::Set(i, hn::GetLane(c.x[0])), y = hn::Set(i, hn::GetLane(c.y[0]));
  for (int v = 0; v < 3; ++v) {
    c.x[v] = hn::IfThenElse(there, c.x[v], x);
    c.y[v] = hn::IfThenElse(there, c.y[v], y);
  }
}

/// Triangles [k, k + lanes) of a chunk, as far as they are there and lie in the tile.
template <int kSamples>
HWY_INLINE void set_up(const TriangleChunk& t, std::size_t k, std::span<const SampleOffset> pattern,
                       const SampleLimits& limits, const TileBuffer& tile, Group<kSamples>& g) {
  const F f;
  const I i;
  const PixelRect& rect = tile.rect;
  Binned binned = load_binned(t, k, rect.x0, rect.y0);
  Corners& c = binned.at;
  const std::size_t count = static_cast<std::size_t>(t.size) - k;
  if (count < hn::Lanes(i)) make_points_beyond(count, c);
  const VI x = hn::Max(first_pixel(least(c.x), limits.most_x), hn::Set(i, rect.x0));
  const VI y = hn::Max(first_pixel(least(c.y), limits.most_y), hn::Set(i, rect.y0));
  const VI last_x = hn::Min(last_pixel(most(c.x), limits.least_x), hn::Set(i, rect.x1 - 1));
  const VI last_y = hn::Min(last_pixel(most(c.y), limits.least_y), hn::Set(i, rect.y1 - 1));
  g.columns = hn::GetLane(hn::MaxOfLanes(i, hn::Sub(last_x, x))) + 1;
  g.rows = hn::GetLane(hn::MaxOfLanes(i, hn::Sub(last_y, y))) + 1;
  g.box = {hn::GetLane(hn::MinOfLanes(i, x)), hn::GetLane(hn::MinOfLanes(i, y)),
           hn::GetLane(hn::MaxOfLanes(i, last_x)) + 1, hn::GetLane(hn::MaxOfLanes(i, last_y)) + 1};
  g.columns_left = hn::Sub(hn::Set(i, rect.x1 - 1), x);
  g.rows_left = hn::Sub(hn::Set(i, rect.y1 - 1), y);
  const VI corner_x = hn::ShiftLeft<8>(x), corner_y = hn::ShiftLeft<8>(y);
  HWY_UNROLL(3)
  for (int e = 0; e < 3; ++e) {
    const Edge edge = edge_at(c, e, corner_x, corner_y);
    g.dx[e] = edge.dx;
    g.dy[e] = edge.dy;
    // E / 256, rounded down, keeps the sign, since pixels lie 256 raw units apart and a step by one
    // adds whole numbers, -dy or dx.
    HWY_UNROLL(8)
    for (std::size_t s = 0; s < kSamples; ++s) {
      const VI shift = hn::Sub(hn::Mul(edge.dx, hn::Set(i, pattern[s].y.raw())),
                               hn::Mul(edge.dy, hn::Set(i, pattern[s].x.raw())));
      g.edge[s][e] = hn::ShiftRight<8>(hn::Add(edge.e, shift));
    }
  }
  const DepthPlanes depth = depth_planes(c, binned.z[0], binned.z[1], binned.z[2]);
  g.z = depth.z;
  g.dz_dx = depth.dz_dx;
  g.dz_dy = depth.dz_dy;
  g.nearest = depth.nearest;
  g.farthest = depth.farthest;
  const VF x_px = hn::ConvertTo(f, x), y_px = hn::ConvertTo(f, y);
  HWY_UNROLL(8)
  for (std::size_t s = 0; s < kSamples; ++s) {
    g.from_x[s] = hn::Sub(hn::Add(x_px, hn::Set(f, pattern[s].x.to_float())), depth.x_px);
    g.from_y[s] = hn::Sub(hn::Add(y_px, hn::Set(f, pattern[s].y.to_float())), depth.y_px);
  }
  g.id = binned.id;
  const VI base = hn::Set(i, -rect.y0 * tile.stride - rect.x0);
  g.pixel = hn::BitCast(U(), hn::Add(hn::Add(hn::Mul(y, hn::Set(i, tile.stride)), x), base));
}

/// The steps of a group in which some triangle covers a sample.
template <int kSamples>
struct Hits {
  static constexpr std::size_t kCapacity = kMaxSteps * kMaxSteps + 1;
  struct Hit {
    std::uint8_t column, row;
    std::uint8_t any;                            ///< a bit for each triangle that covers a sample
    std::array<std::uint8_t, kSamples> covered;  ///< and of each sample
  };
  std::array<Hit, kCapacity> hit;
  std::size_t size;
};

/// The lanes that are not negative, a bit each.
HWY_INLINE std::uint8_t bits_where_covered(VI outside) {
  const I i;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(i, hn::Gt(outside, hn::Set(i, -1)), bits);
  return bits[0];
}

/// Looks at every step, and keeps those that cover something. No branch asks which: nobody can
/// predict it.
/// @param kWithin  all triangles lie within the tile
template <int kSamples, bool kWithin>
HWY_INLINE void find_hits(const Group<kSamples>& g, Hits<kSamples>& hits) {
  const I i;
  const VI one = hn::Set(i, 1);
  // Along the box: the first sample's edges, which all others differ from by constants.
  VI row[3] = {g.edge[0][0], g.edge[0][1], g.edge[0][2]}, others[kSamples][3];
  HWY_UNROLL(8)
  for (std::size_t s = 1; s < kSamples; ++s) {
    HWY_UNROLL(3)
    for (int e = 0; e < 3; ++e) others[s][e] = hn::Sub(g.edge[s][e], row[e]);
  }
  VI rows_left = g.rows_left;
  std::size_t n = 0;
  for (int r = 0; r < g.rows; ++r) {
    VI e0 = row[0], e1 = row[1], e2 = row[2], columns_left = g.columns_left;
    for (int c = 0; c < g.columns; ++c) {
      VI beyond = hn::Zero(i);
      if (!kWithin) beyond = hn::Or(rows_left, columns_left);
      const VI outside = hn::Or(hn::Or(e0, e1), kWithin ? e2 : hn::Or(e2, beyond));
      VI everywhere = outside;
      auto& hit = hits.hit[n];
      hit.column = static_cast<std::uint8_t>(c);
      hit.row = static_cast<std::uint8_t>(r);
      if constexpr (kSamples > 1) {
        hit.covered[0] = bits_where_covered(outside);
        HWY_UNROLL(8)
        for (std::size_t s = 1; s < kSamples; ++s) {
          VI at = hn::Or(hn::Or(hn::Add(e0, others[s][0]), hn::Add(e1, others[s][1])),
                         hn::Add(e2, others[s][2]));
          if (!kWithin) at = hn::Or(at, beyond);
          everywhere = hn::And(everywhere, at);
          hit.covered[s] = bits_where_covered(at);
        }
      }
      hit.any = bits_where_covered(everywhere);
      n += hit.any != 0 ? 1 : 0;
      e0 = hn::Sub(e0, g.dy[0]);
      e1 = hn::Sub(e1, g.dy[1]);
      e2 = hn::Sub(e2, g.dy[2]);
      if (!kWithin) columns_left = hn::Sub(columns_left, one);
    }
    HWY_UNROLL(3)
    for (int e = 0; e < 3; ++e) row[e] = hn::Add(row[e], g.dx[e]);
    if (!kWithin) rows_left = hn::Sub(rows_left, one);
  }
  hits.size = n;
}

/// Steps as numbers to add to a place: exact, since places are small multiples of 1/256.
constexpr auto kSteps = [] {
  std::array<float, kMaxSteps> steps{};
  for (std::size_t n = 0; n < steps.size(); ++n) steps[n] = static_cast<float>(n);
  return steps;
}();

static_assert(FragmentBuffer::kEnough + 8 * (kMaxSteps * kMaxSteps + 1) <=
              FragmentBuffer::kCapacity);

/// Appends the fragments of all hits, for which there is room.
template <int kSamples>
HWY_INLINE void append(const Group<kSamples>& g, const Hits<kSamples>& hits, int stride,
                       FragmentBuffer& to) {
  const F f;
  const VF uncovered = hn::Set(f, std::numeric_limits<float>::infinity());
  std::size_t n = to.size;
  for (std::size_t h = 0; h < hits.size; ++h) {
    const auto& hit = hits.hit[h];
    const Packer<I> pack(hit.any);
    const auto pixel = static_cast<std::uint32_t>(hit.row * stride + hit.column);
    pack.store(hn::Add(g.pixel, hn::Set(U(), pixel)), to.pixel.data() + n);
    pack.store(g.id, to.id.data() + n);
    const VF column = hn::Set(f, kSteps[hit.column]), row = hn::Set(f, kSteps[hit.row]);
    HWY_UNROLL(8)
    for (std::size_t s = 0; s < kSamples; ++s) {
      // DepthPlane::at, with its roundings.
      const VF row_z = hn::Add(g.z, hn::Mul(g.dz_dy, hn::Add(g.from_y[s], row)));
      const VF plane = hn::Add(row_z, hn::Mul(g.dz_dx, hn::Add(g.from_x[s], column)));
      VF z = hn::Min(hn::Max(plane, g.nearest), g.farthest);
      if (kSamples > 1) z = hn::IfThenElse(mask_of_bits(f, hit.covered[s]), z, uncovered);
      pack.store(z, to.depth[s].data() + n);
    }
    n += pack.count();
  }
  to.size = n;
}

template <int kSamples, bool kWithin>
HWY_INLINE void draw_all(const ChunkList<TriangleChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile,
                         FragmentBuffer& buffer) {
  const std::size_t lanes = hn::Lanes(F());
  const LaneParts<kSamples> parts(pattern);
  const SampleLimits limits = sample_limits(pattern);
  Group<kSamples> group;
  Hits<kSamples> hits;
  for (const TriangleChunk* chunk = triangles.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t k = 0; k < size; k += lanes) {
      prefetch(chunk->next, k / lanes, TriangleChunk::kCapacity / lanes);
      set_up(*chunk, k, pattern, limits, tile, group);
      if (group.box.empty()) continue;
      find_hits<kSamples, kWithin>(group, hits);
      store_blocks(blocks_touched(group.box, tile), parts, tile);
      append(group, hits, tile.stride, buffer);
      if (buffer.size > FragmentBuffer::kEnough) merge_fragments<kSamples>(buffer, tile);
    }
  }
  merge_fragments<kSamples>(buffer, tile);
}

template <int kSamples>
HWY_INLINE void draw_list(const ChunkList<TriangleChunk>& triangles, bool across,
                          std::span<const SampleOffset> pattern, TileBuffer& tile,
                          FragmentBuffer& buffer) {
  if (across) {
    draw_all<kSamples, /*kWithin=*/false>(triangles, pattern, tile, buffer);
  } else {
    draw_all<kSamples, /*kWithin=*/true>(triangles, pattern, tile, buffer);
  }
}

void DrawSmallTriangles(const ChunkList<TriangleChunk>& triangles, bool across,
                        std::span<const SampleOffset> pattern, TileBuffer& tile,
                        FragmentBuffer& buffer) {
  switch (pattern.size()) {
    case 1:
      return draw_list<1>(triangles, across, pattern, tile, buffer);
    case 4:
      return draw_list<4>(triangles, across, pattern, tile, buffer);
    default:
      return draw_list<8>(triangles, across, pattern, tile, buffer);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawSmallTriangles);

void draw_small_triangles(const ChunkList<TriangleChunk>& triangles, bool across,
                          std::span<const SampleOffset> pattern, TileBuffer& tile,
                          FragmentBuffer& buffer) {
  if (triangles.first == nullptr) return;
  HWY_DYNAMIC_DISPATCH(DrawSmallTriangles)(triangles, across, pattern, tile, buffer);
}

}  // namespace kinescope
#endif
