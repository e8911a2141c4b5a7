#include "raster/kernels/small_triangles.h"

#include <algorithm>
#include <array>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/pack-inl.h"
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

/// What one position of the group's boxes shows: in each lane a pixel of that lane's triangle.
template <int kSamples>
struct Step {
  hn::Mask<I> covered;  // any sample
  VI x, y;
  VF z[kSamples];  // if there are several, infinite where a sample is not covered
};

/// Edges of the group at one sample of the boxes' first pixels: E / 256, rounded down, keeps the
/// sign, since pixels lie 256 raw units apart and a step by one adds whole numbers, -dy or dx.
HWY_INLINE void edges_at(const Group& g, SampleOffset sample, VI (&out)[3]) {
  const I i;
  for (int e = 0; e < 3; ++e) {
    const Edge& edge = g.edge[e];
    const VI shift = hn::Sub(hn::Mul(edge.dx, hn::Set(i, sample.y.raw())),
                             hn::Mul(edge.dy, hn::Set(i, sample.x.raw())));
    out[e] = hn::ShiftRight<8>(hn::Add(edge.e, shift));
  }
}

/// Calls sink(step) wherever a triangle of the group covers a sample.
template <int kSamples, typename Sink>
HWY_INLINE void draw_group(const Group& g, std::span<const SampleOffset> pattern,
                           const Sink& sink) {
  const F f;
  const I i;
  const VI minus_one = hn::Set(i, -1), one = hn::Set(i, 1);
  const VF uncovered = hn::Set(f, std::numeric_limits<float>::infinity());
  VI first[kSamples][3];
  for (std::size_t s = 0; s < kSamples; ++s) edges_at(g, pattern[s], first[s]);
  // Along the boxes: the first sample's edges, which all others differ from by constants.
  VI row[3] = {first[0][0], first[0][1], first[0][2]};
  for (std::size_t s = 1; s < kSamples; ++s) {
    for (int e = 0; e < 3; ++e) first[s][e] = hn::Sub(first[s][e], row[e]);
  }
  Step<kSamples> step;
  VF row_z[kSamples];
  step.y = g.y;
  for (int r = 0; r < g.rows; ++r) {
    const VF y = hn::ConvertTo(f, step.y);
    for (std::size_t s = 0; s < kSamples; ++s) {
      const VF py = hn::Add(y, hn::Set(f, pattern[s].y.to_float()));
      row_z[s] = hn::Add(g.depth.z, hn::Mul(g.depth.dz_dy, hn::Sub(py, g.depth.y_px)));
    }
    VI e0 = row[0], e1 = row[1], e2 = row[2];
    step.x = g.x;
    for (int c = 0; c < g.columns; ++c) {
      VI outside[kSamples];  // negative
      outside[0] = hn::Or(hn::Or(e0, e1), e2);
      VI everywhere = outside[0];
      for (std::size_t s = 1; s < kSamples; ++s) {
        outside[s] = hn::Or(hn::Or(hn::Add(e0, first[s][0]), hn::Add(e1, first[s][1])),
                            hn::Add(e2, first[s][2]));
        everywhere = hn::And(everywhere, outside[s]);
      }
      step.covered = hn::Gt(everywhere, minus_one);
      if (!hn::AllFalse(i, step.covered)) {
        const VF x = hn::ConvertTo(f, step.x);
        for (std::size_t s = 0; s < kSamples; ++s) {
          const VF px = hn::Add(x, hn::Set(f, pattern[s].x.to_float()));
          const VF plane = hn::Add(row_z[s], hn::Mul(g.depth.dz_dx, hn::Sub(px, g.depth.x_px)));
          const VF z = hn::Min(hn::Max(plane, g.depth.nearest), g.depth.farthest);
          const auto is_covered = hn::RebindMask(f, hn::Gt(outside[s], minus_one));
          step.z[s] = kSamples == 1 ? z : hn::IfThenElse(is_covered, z, uncovered);
        }
        sink(step);
      }
      e0 = hn::Sub(e0, g.edge[0].dy);
      e1 = hn::Sub(e1, g.edge[1].dy);
      e2 = hn::Sub(e2, g.edge[2].dy);
      step.x = hn::Add(step.x, one);
    }
    for (int e = 0; e < 3; ++e) row[e] = hn::Add(row[e], g.edge[e].dx);
    step.y = hn::Add(step.y, one);
  }
}

/// Appends the covered lanes to arrays of fragments, which have room for a whole vector.
template <int kSamples, class Fragments>
HWY_INLINE void append(const Step<kSamples>& step, const Packer<I>& pack, VI pixel, VU id,
                       Fragments& to) {
  const auto n = static_cast<std::size_t>(to.size);
  pack.store(hn::BitCast(U(), pixel), to.pixel.data() + n);
  pack.store(id, to.id.data() + n);
  for (std::size_t s = 0; s < kSamples; ++s) pack.store(step.z[s], to.depth[s].data() + n);
  to.size += static_cast<int>(pack.count());
}

/// Where a worker puts fragments of pixels with that many samples.
template <int kSamples>
HWY_INLINE auto& lists_of(Bins& bins) {
  if constexpr (kSamples == 1) {
    return bins.fragments;
  } else {
    return bins.sampled;
  }
}
template <int kSamples>
HWY_INLINE auto& pool_of(Bins& bins) {
  if constexpr (kSamples == 1) {
    return bins.fragment_pool;
  } else {
    return bins.sampled_pool;
  }
}

/// A group whose triangles all lie in one tile: whole vectors are appended, compressed.
template <int kSamples>
HWY_INLINE void draw_in_tile(const Group& g, std::span<const SampleOffset> pattern,
                             const TileGrid& grid, int tile, Bins& bins) {
  const I i;
  const int lanes = static_cast<int>(hn::Lanes(i));
  const PixelRect rect = grid.rect(tile);
  auto& list = lists_of<kSamples>(bins)[static_cast<std::size_t>(tile)];
  auto* chunk = &list.tail(pool_of<kSamples>(bins), lanes);
  const VI stride = hn::Set(i, grid.tile_width);
  const VI base = hn::Set(i, -rect.y0 * grid.tile_width - rect.x0);
  draw_group<kSamples>(g, pattern, [&](const Step<kSamples>& step) HWY_ATTR {
    if (chunk->size + lanes > static_cast<int>(chunk->kCapacity)) {
      chunk = &list.tail(pool_of<kSamples>(bins), lanes);
    }
    const Packer<I> pack(step.covered);
    append(step, pack, hn::Add(hn::Add(hn::Mul(step.y, stride), step.x), base), g.id, *chunk);
  });
}

/// Fragments of several tiles, on their way to the bins.
template <int kSamples>
struct MixedFragments {
  static constexpr int kCapacity = 1024;
  alignas(64) std::array<std::uint32_t, kCapacity> tile, pixel, id;
  alignas(64) std::array<std::array<float, kCapacity>, kSamples> depth;
  int size = 0;
};

template <int kSamples>
HWY_NOINLINE void sort_into_bins(MixedFragments<kSamples>& from, Bins& bins) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(from.size); ++i) {
    auto& chunk = lists_of<kSamples>(bins)[from.tile[i]].tail(pool_of<kSamples>(bins));
    const auto n = static_cast<std::size_t>(chunk.size++);
    chunk.pixel[n] = from.pixel[i];
    chunk.id[n] = from.id[i];
    for (std::size_t s = 0; s < kSamples; ++s) chunk.depth[s][n] = from.depth[s][i];
  }
  from.size = 0;
}

/// A group across several tiles.
template <int kSamples>
HWY_INLINE void draw_across_tiles(const Group& g, std::span<const SampleOffset> pattern,
                                  const TileGrid& grid, MixedFragments<kSamples>& out, Bins& bins) {
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
  draw_group<kSamples>(g, pattern, [&](const Step<kSamples>& step) HWY_ATTR {
    const VI column = divide(step.x, per_column), row = divide(step.y, per_row);
    const VI tile = hn::Add(hn::Mul(row, columns), column);
    const VI in_x = hn::Sub(step.x, hn::Mul(column, tile_width));
    const VI in_y = hn::Sub(step.y, hn::Mul(row, tile_height));
    const Packer<I> pack(step.covered);
    pack.store(hn::BitCast(u, tile), out.tile.data() + out.size);
    append(step, pack, hn::Add(hn::Mul(in_y, tile_width), in_x), g.id, out);
    if (out.size + lanes > out.kCapacity) sort_into_bins(out, bins);
  });
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

template <int kSamples>
HWY_INLINE void draw_all(CulledTriangles::Snapped& t, std::uint32_t first_id,
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
  MixedFragments<kSamples> mixed;
  for (std::size_t k = 0; k < size; k += lanes) {
    const Group g = set_up(t, k, first_id, limits);
    if (g.columns <= 0 || g.rows <= 0) continue;
    const int tile = common_tile(g, grid);
    if (tile >= 0) {
      draw_in_tile<kSamples>(g, pattern, grid, tile, bins);
    } else {
      draw_across_tiles<kSamples>(g, pattern, grid, mixed, bins);
    }
  }
  sort_into_bins(mixed, bins);
}

void DrawSmallTriangles(CulledTriangles::Snapped& t, std::uint32_t first_id,
                        std::span<const SampleOffset> pattern, const SampleLimits& limits,
                        const TileGrid& grid, Bins& bins) {
  switch (pattern.size()) {
    case 1:
      return draw_all<1>(t, first_id, pattern, limits, grid, bins);
    case 4:
      return draw_all<4>(t, first_id, pattern, limits, grid, bins);
    default:
      return draw_all<8>(t, first_id, pattern, limits, grid, bins);
  }
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
