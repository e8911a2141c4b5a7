#include "raster/kernels/small_triangles.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
/// Triangles to be drawn together, pixel by pixel of the largest box.
struct Group {
  Edge edge[3];  // E at the corner of the box's first pixel
  VI x, y;       // first pixel of the box
  DepthPlanes depth;
  VU id;
  int columns, rows;  // of the largest box
};

HWY_INLINE Group set_up(const CulledTriangles::Snapped& t, std::size_t k, std::uint32_t first_id,
                        const SampleLimits& limits) {
  const I i;
  const U u;
  const Corners c = load_corners(t, k);
  const auto first = [&](VI raw, Fixed24_8 offset) HWY_ATTR {
    return hn::ShiftRight<8>(hn::Add(raw, hn::Set(i, 255 - offset.raw())));
  };
  const auto last = [&](VI raw, Fixed24_8 offset) HWY_ATTR {
    return hn::ShiftRight<8>(hn::Sub(raw, hn::Set(i, offset.raw())));
  };
  Group g;
  g.x = first(least(c.x), limits.most_x);
  g.y = first(least(c.y), limits.most_y);
  const VI columns = hn::Sub(last(most(c.x), limits.least_x), g.x);
  const VI rows = hn::Sub(last(most(c.y), limits.least_y), g.y);
  g.columns = hn::GetLane(hn::MaxOfLanes(i, columns)) + 1;
  g.rows = hn::GetLane(hn::MaxOfLanes(i, rows)) + 1;
  const VI corner_x = hn::ShiftLeft<8>(g.x), corner_y = hn::ShiftLeft<8>(g.y);
  for (int e = 0; e < 3; ++e) g.edge[e] = edge_at(c, e, corner_x, corner_y);
  g.depth = depth_planes(t, k, c);
  g.id = hn::Add(hn::LoadU(u, t.triangle.data() + k), hn::Set(u, first_id));
  return g;
}

/// Calls sink(mask, x, y, z) for each step across the boxes of a group, for one sample.
template <typename Sink>
HWY_INLINE void draw_sample(const Group& g, SampleOffset sample, const Sink& sink) {
  const F f;
  const I i;
  const VI minus_one = hn::Set(i, -1), one = hn::Set(i, 1);
  // Dividing by 256, rounded down, keeps the sign: pixels lie 256 raw units apart, so that a step
  // by one adds whole numbers, -dy or dx.
  VI row_e[3];
  for (int e = 0; e < 3; ++e) {
    const Edge& edge = g.edge[e];
    const VI shift = hn::Sub(hn::Mul(edge.dx, hn::Set(i, sample.y.raw())),
                             hn::Mul(edge.dy, hn::Set(i, sample.x.raw())));
    row_e[e] = hn::ShiftRight<8>(hn::Add(edge.e, shift));
  }
  const VF sample_x = hn::Set(f, sample.x.to_float()), sample_y = hn::Set(f, sample.y.to_float());
  VI y = g.y;
  for (int r = 0; r < g.rows; ++r) {
    const VF py = hn::Add(hn::ConvertTo(f, y), sample_y);
    const VF row_z = hn::Add(g.depth.z, hn::Mul(g.depth.dz_dy, hn::Sub(py, g.depth.y_px)));
    VI e0 = row_e[0], e1 = row_e[1], e2 = row_e[2], x = g.x;
    for (int c = 0; c < g.columns; ++c) {
      const auto covered = hn::Gt(hn::Or(hn::Or(e0, e1), e2), minus_one);
      if (!hn::AllFalse(i, covered)) {
        const VF px = hn::Add(hn::ConvertTo(f, x), sample_x);
        const VF plane = hn::Add(row_z, hn::Mul(g.depth.dz_dx, hn::Sub(px, g.depth.x_px)));
        sink(covered, x, y, hn::Min(hn::Max(plane, g.depth.nearest), g.depth.farthest));
      }
      e0 = hn::Sub(e0, g.edge[0].dy);
      e1 = hn::Sub(e1, g.edge[1].dy);
      e2 = hn::Sub(e2, g.edge[2].dy);
      x = hn::Add(x, one);
    }
    for (int e = 0; e < 3; ++e) row_e[e] = hn::Add(row_e[e], g.edge[e].dx);
    y = hn::Add(y, one);
  }
}

/// A group whose triangles all lie in one tile: whole vectors are appended, compressed.
HWY_INLINE void draw_in_tile(const Group& g, std::span<const SampleOffset> pattern,
                             const TileGrid& grid, int tile, Bins& bins) {
  const F f;
  const I i;
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(i));
  const PixelRect rect = grid.rect(tile);
  ChunkList<FragmentChunk>& list = bins.fragments[static_cast<std::size_t>(tile)];
  FragmentChunk* chunk = &list.tail(bins.fragment_pool, lanes);
  const VI stride = hn::Set(i, grid.tile_width);
  for (std::size_t s = 0; s < pattern.size(); ++s) {
    const int origin = static_cast<int>(s) * grid.tile_width * grid.tile_height -
                       rect.y0 * grid.tile_width - rect.x0;
    const VI base = hn::Set(i, origin);
    draw_sample(g, pattern[s], [&](auto covered, VI x, VI y, VF z) HWY_ATTR {
      if (chunk->size + lanes > FragmentChunk::kCapacity) {
        chunk = &list.tail(bins.fragment_pool, lanes);
      }
      const VI place = hn::Add(hn::Add(hn::Mul(y, stride), x), base);
      const auto n = static_cast<std::size_t>(chunk->size);
      hn::StoreU(hn::Compress(hn::BitCast(u, place), hn::RebindMask(u, covered)), u,
                 chunk->place.data() + n);
      hn::StoreU(hn::Compress(z, hn::RebindMask(f, covered)), f, chunk->depth.data() + n);
      hn::StoreU(hn::Compress(g.id, hn::RebindMask(u, covered)), u, chunk->id.data() + n);
      chunk->size += static_cast<int>(hn::CountTrue(i, covered));
    });
  }
}

/// Fragments of several tiles, on their way to the bins.
struct MixedFragments {
  static constexpr int kCapacity = 1024;
  alignas(64) std::array<std::uint32_t, kCapacity> tile, place, id;
  alignas(64) std::array<float, kCapacity> depth;
  int size = 0;
};

HWY_NOINLINE void sort_into_bins(MixedFragments& from, Bins& bins) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(from.size); ++i) {
    FragmentChunk& chunk = bins.fragments[from.tile[i]].tail(bins.fragment_pool);
    const auto n = static_cast<std::size_t>(chunk.size++);
    chunk.place[n] = from.place[i];
    chunk.depth[n] = from.depth[i];
    chunk.id[n] = from.id[i];
  }
  from.size = 0;
}

/// A group across several tiles.
HWY_INLINE void draw_across_tiles(const Group& g, std::span<const SampleOffset> pattern,
                                  const TileGrid& grid, MixedFragments& out, Bins& bins) {
  const F f;
  const I i;
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(i));
  const VI tile_width = hn::Set(i, grid.tile_width), tile_height = hn::Set(i, grid.tile_height);
  const VI columns = hn::Set(i, grid.columns);
  const VF per_column = hn::Set(f, 1.0f / static_cast<float>(grid.tile_width));
  const VF per_row = hn::Set(f, 1.0f / static_cast<float>(grid.tile_height));
  // A pixel's centre is at least half a pixel from a tile's edge: more than the rounding.
  const auto divide = [&](VI pixel, VF per) HWY_ATTR {
    const VF centre = hn::Add(hn::ConvertTo(f, pixel), hn::Set(f, 0.5f));
    return hn::ConvertTo(i, hn::Mul(centre, per));
  };
  for (std::size_t s = 0; s < pattern.size(); ++s) {
    const VI plane = hn::Set(i, static_cast<int>(s) * grid.tile_width * grid.tile_height);
    draw_sample(g, pattern[s], [&](auto covered, VI x, VI y, VF z) HWY_ATTR {
      const VI column = divide(x, per_column), row = divide(y, per_row);
      const VI tile = hn::Add(hn::Mul(row, columns), column);
      const VI in_x = hn::Sub(x, hn::Mul(column, tile_width));
      const VI in_y = hn::Sub(y, hn::Mul(row, tile_height));
      const VI place = hn::Add(hn::Add(hn::Mul(in_y, tile_width), in_x), plane);
      const auto n = static_cast<std::size_t>(out.size);
      const auto lanes_covered = hn::RebindMask(u, covered);
      hn::StoreU(hn::Compress(hn::BitCast(u, tile), lanes_covered), u, out.tile.data() + n);
      hn::StoreU(hn::Compress(hn::BitCast(u, place), lanes_covered), u, out.place.data() + n);
      hn::StoreU(hn::Compress(g.id, lanes_covered), u, out.id.data() + n);
      hn::StoreU(hn::Compress(z, hn::RebindMask(f, covered)), f, out.depth.data() + n);
      out.size += static_cast<int>(hn::CountTrue(i, covered));
      if (out.size + lanes > MixedFragments::kCapacity) sort_into_bins(out, bins);
    });
  }
}

/// The tile that holds all boxes of the group, or -1.
HWY_INLINE int common_tile(const Group& g, const TileGrid& grid) {
  const I i;
  const int x0 = hn::GetLane(hn::MinOfLanes(i, g.x));
  const int y0 = hn::GetLane(hn::MinOfLanes(i, g.y));
  const int x1 = hn::GetLane(hn::MaxOfLanes(i, g.x)) + g.columns - 1;
  const int y1 = hn::GetLane(hn::MaxOfLanes(i, g.y)) + g.rows - 1;
  const int column = grid.column_of(x0), row = grid.row_of(y0);
  const bool one = x1 < (column + 1) * grid.tile_width && y1 < (row + 1) * grid.tile_height;
  return one ? row * grid.columns + column : -1;
}

void DrawSmallTriangles(CulledTriangles::Snapped& t, std::uint32_t first_id,
                        std::span<const SampleOffset> pattern, const SampleLimits& limits,
                        const TileGrid& grid, Bins& bins) {
  const I i;
  const auto lanes = static_cast<std::size_t>(hn::Lanes(i));
  const auto size = static_cast<std::size_t>(t.size);
  if (size == 0) return;
  // The last vector is filled up with points: they cover nothing, and lie near the others.
  const std::size_t padded = (size + lanes - 1) / lanes * lanes;
  for (std::size_t k = size; k < padded; ++k) {
    for (std::size_t v = 0; v < 3; ++v) {
      t.x[v][k] = t.x[0][size - 1];
      t.y[v][k] = t.y[0][size - 1];
      t.z[v][k] = 0.0f;
    }
    t.triangle[k] = 0;
  }
  MixedFragments mixed;
  for (std::size_t k = 0; k < size; k += lanes) {
    const Group g = set_up(t, k, first_id, limits);
    if (g.columns <= 0 || g.rows <= 0) continue;
    const int tile = common_tile(g, grid);
    if (tile >= 0) {
      draw_in_tile(g, pattern, grid, tile, bins);
    } else {
      draw_across_tiles(g, pattern, grid, mixed, bins);
    }
  }
  sort_into_bins(mixed, bins);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawSmallTriangles);

void draw_small_triangles(CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                          std::span<const SampleOffset> pattern, const TileGrid& grid, Bins& bins) {
  HWY_DYNAMIC_DISPATCH(DrawSmallTriangles)
  (triangles, first_id, pattern, sample_limits(pattern), grid, bins);
}

}  // namespace kinescope
#endif
