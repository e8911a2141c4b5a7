#include "raster/kernels/small_triangles.h"

#include <algorithm>
#include <array>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/merge_fragments-inl.h"
#include "raster/kernels/pack-inl.h"
#include "raster/kernels/prefetch-inl.h"
#include "raster/kernels/tile_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
/// Triangles to be drawn together, pixel by pixel of the largest box.
struct Group {
  Edge edge[3];  // E at the corner of the box's first pixel
  VI x, y;       // first pixel of the box
  DepthPlanes depth;
  VU id;
  int columns, rows;  // of the largest box
  PixelRect box;      // of all
};

/// Triangles [k, k + lanes).
HWY_INLINE Group set_up(const TriangleChunk& t, std::size_t k, const SampleLimits& limits) {
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
  g.id = hn::LoadU(u, t.id.data() + k);
  const int x0 = hn::GetLane(hn::MinOfLanes(i, g.x)), y0 = hn::GetLane(hn::MinOfLanes(i, g.y));
  g.box = {x0, y0, hn::GetLane(hn::MaxOfLanes(i, hn::Add(g.x, columns))) + 1,
           hn::GetLane(hn::MaxOfLanes(i, hn::Add(g.y, rows))) + 1};
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

/// Calls sink(step) wherever a triangle of the group covers a sample of the tile.
template <int kSamples, bool kWithin, typename Sink>
HWY_INLINE void draw_group(const Group& g, std::span<const SampleOffset> pattern,
                           const PixelRect& tile, const Sink& sink) {
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
    const VI row_outside =
        hn::Or(hn::Sub(step.y, hn::Set(i, tile.y0)), hn::Sub(hn::Set(i, tile.y1 - 1), step.y));
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
      if (!kWithin) {
        const VI column_outside =
            hn::Or(hn::Sub(step.x, hn::Set(i, tile.x0)), hn::Sub(hn::Set(i, tile.x1 - 1), step.x));
        everywhere = hn::Or(everywhere, hn::Or(row_outside, column_outside));
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

/// Appends the covered lanes, which are no more than there is room for.
template <int kSamples>
HWY_INLINE void append(const Step<kSamples>& step, const TileBuffer& tile, VU id,
                       FragmentBuffer& to) {
  const I i;
  const Packer<I> pack(step.covered);
  const VI base = hn::Set(i, -tile.rect.y0 * tile.stride - tile.rect.x0);
  const VI pixel = hn::Add(hn::Add(hn::Mul(step.y, hn::Set(i, tile.stride)), step.x), base);
  pack.store(hn::BitCast(U(), pixel), to.pixel.data() + to.size);
  pack.store(id, to.id.data() + to.size);
  for (std::size_t s = 0; s < kSamples; ++s) pack.store(step.z[s], to.depth[s].data() + to.size);
  to.size += pack.count();
}

/// Those of a group that touch the tile.
template <int kSamples, bool kWithin>
HWY_INLINE void draw_in_tile(const Group& g, std::span<const SampleOffset> pattern,
                             const LaneParts<kSamples>& parts, TileBuffer& tile,
                             FragmentBuffer& buffer) {
  const PixelRect& r = tile.rect;
  const PixelRect box = {std::max(g.box.x0, r.x0), std::max(g.box.y0, r.y0),
                         std::min(g.box.x1, r.x1), std::min(g.box.y1, r.y1)};
  if (box.empty()) return;
  store_blocks(blocks_touched(box, tile), parts, tile);
  draw_group<kSamples, kWithin>(g, pattern, r, [&](const Step<kSamples>& step) HWY_ATTR {
    append(step, tile, g.id, buffer);
    if (buffer.size + 8 > FragmentBuffer::kCapacity) merge_fragments<kSamples>(buffer, tile);
  });
}

/// Fills the chunk's last vector up with points: they cover nothing, and lie near the others.
HWY_INLINE void pad(const TriangleChunk& from, std::size_t k, std::size_t lanes,
                    TriangleChunk& to) {
  const auto size = static_cast<std::size_t>(from.size);
  for (std::size_t n = 0; n < lanes; ++n) {
    const std::size_t i = std::min(k + n, size - 1);
    for (std::size_t v = 0; v < 3; ++v) {
      const std::size_t corner = k + n < size ? v : 0;
      to.x[v][n] = from.x[corner][i];
      to.y[v][n] = from.y[corner][i];
      to.z[v][n] = from.z[corner][i];
    }
    to.id[n] = from.id[i];
  }
}

template <int kSamples, bool kWithin>
HWY_INLINE void draw_all(const ChunkList<TriangleChunk>& triangles,
                         std::span<const SampleOffset> pattern, TileBuffer& tile,
                         FragmentBuffer& buffer) {
  const std::size_t lanes = hn::Lanes(F());
  const LaneParts<kSamples> parts(pattern);
  const SampleLimits limits = sample_limits(pattern);
  TriangleChunk last;
  for (const TriangleChunk* chunk = triangles.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t k = 0; k < size; k += lanes) {
      const bool whole = k + lanes <= size;
      if (!whole) pad(*chunk, k, lanes, last);
      prefetch(chunk->next, k / lanes, TriangleChunk::kCapacity / lanes);
      const Group g = whole ? set_up(*chunk, k, limits) : set_up(last, 0, limits);
      draw_in_tile<kSamples, kWithin>(g, pattern, parts, tile, buffer);
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
