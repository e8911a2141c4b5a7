#include "raster/kernels/cull.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/cull.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/pack-inl.h"
#include "raster/kernels/set_up-inl.h"
#include "raster/kernels/vertex_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Vertex k of several triangles.
struct Corner {
  VI x, y;
  VF z;
};

/// A range of pixels [first, end) along one axis, and the box's extent in raw units.
struct Extent {
  VI first, end, raw;
};

/// @param index  of the vertex, three apart from triangle to triangle
HWY_INLINE Corner load_corner(const DeviceVertex* vertices, const std::uint32_t* index,
                              hn::Mask<F>& drawable) {
  const F f;
  const auto guard = hn::Set(f, DeviceVertex::kGuardBand);
  const auto largest = hn::Set(f, std::numeric_limits<float>::max());
  const auto [x, y, z, inv_w] = load_vertices(f, vertices, index, 3);
  // NaN fails each comparison.
  drawable = hn::And(drawable, hn::And(hn::Le(hn::Abs(x), guard), hn::Le(hn::Abs(y), guard)));
  drawable = hn::And(drawable, hn::Le(hn::Abs(z), largest));
  const auto scale = hn::Set(f, static_cast<float>(Fixed24_8::kOne));
  const auto clamped = hn::Min(hn::Max(z, hn::Zero(f)), hn::Set(f, 1.0f));
  return {hn::NearestInt(hn::Mul(x, scale)), hn::NearestInt(hn::Mul(y, scale)),
          hn::Add(clamped, hn::Zero(f))};  // -0 becomes 0
}

HWY_INLINE Extent extent_of(VI a, VI b, VI c, Fixed24_8 least_offset, Fixed24_8 most_offset) {
  const VI lo = hn::Min(hn::Min(a, b), c), hi = hn::Max(hn::Max(a, b), c);
  return {first_pixel(lo, most_offset), hn::Add(last_pixel(hi, least_offset), hn::Set(I(), 1)),
          hn::Sub(hi, lo)};
}

/// Triangles of positive area: the front faces turned round.
struct Turned {
  Corners at;
  VF z[3];
};

HWY_INLINE Turned turned(const Corner& a, const Corner& b, const Corner& c, hn::Mask<I> front) {
  const auto front_f = hn::RebindMask(F(), front);
  return {{{a.x, hn::IfThenElse(front, c.x, b.x), hn::IfThenElse(front, b.x, c.x)},
           {a.y, hn::IfThenElse(front, c.y, b.y), hn::IfThenElse(front, b.y, c.y)}},
          {a.z, hn::IfThenElse(front_f, c.z, b.z), hn::IfThenElse(front_f, b.z, c.z)}};
}

/// Appends some of the triangles.
HWY_INLINE void append(const Turned& t, hn::Mask<I> chosen, VU triangle,
                       CulledTriangles::Snapped& out) {
  if (hn::AllFalse(I(), chosen)) return;
  const Packer<I> pack(chosen);
  const auto n = static_cast<std::size_t>(out.size);
  for (std::size_t v = 0; v < 3; ++v) {
    pack.store(t.at.x[v], out.x[v].data() + n);
    pack.store(t.at.y[v], out.y[v].data() + n);
    pack.store(t.z[v], out.z[v].data() + n);
  }
  pack.store(triangle, out.triangle.data() + n);
  out.size += static_cast<int>(pack.count());
}

/// Whether a sample is covered of the pixel right and down of each triangle's (x, y).
HWY_INLINE hn::Mask<I> covers_pixel(const Edge (&edge)[3], int right, int down,
                                    std::span<const SampleOffset> pattern) {
  const I i;
  VI outside = hn::Set(i, -1);  // negative, of all samples
  for (const SampleOffset& sample : pattern) {
    const VI dx = hn::Set(i, 256 * right + sample.x.raw());
    const VI dy = hn::Set(i, 256 * down + sample.y.raw());
    VI e = hn::Zero(i);
    for (const Edge& side : edge) {
      const VI rise = hn::Sub(hn::Mul(side.dx, dy), hn::Mul(side.dy, dx));
      e = hn::Or(e, hn::Add(side.e, rise));
    }
    outside = hn::And(outside, e);
  }
  return hn::Gt(outside, hn::Set(i, -1));
}

/// How many pixels small triangles cover, and the last of them.
struct Coverage {
  hn::Mask<I> is_known;
  VI count, x, y;
};

/// Of triangles whose box holds one pixel, or at one sample a pixel no more than two either way.
HWY_INLINE Coverage coverage(const Corners& t, const Extent& ex, const Extent& ey,
                             hn::Mask<I> chosen, std::span<const SampleOffset> pattern) {
  const I i;
  const int reach = pattern.size() == 1 ? 2 : 1;
  const VI size = hn::Max(hn::Sub(ex.end, ex.first), hn::Sub(ey.end, ey.first));
  Coverage c = {hn::And(chosen, hn::Lt(size, hn::Set(i, reach + 1))), hn::Zero(i), ex.first,
                ey.first};
  if (hn::AllFalse(i, c.is_known)) return c;
  Edge edge[3];
  const VI x = hn::ShiftLeft<8>(ex.first), y = hn::ShiftLeft<8>(ey.first);
  for (int e = 0; e < 3; ++e) edge[e] = edge_at(t, e, x, y);
  for (int down = 0; down < reach; ++down) {
    for (int right = 0; right < reach; ++right) {
      const auto covered = covers_pixel(edge, right, down, pattern);
      c.count = hn::Sub(c.count, hn::VecFromMask(i, covered));
      c.x = hn::IfThenElse(covered, hn::Add(ex.first, hn::Set(i, right)), c.x);
      c.y = hn::IfThenElse(covered, hn::Add(ey.first, hn::Set(i, down)), c.y);
    }
  }
  return c;
}

/// Appends the pixels of triangles that cover no other.
HWY_INLINE void append_pixels(const Turned& t, const Coverage& c, hn::Mask<I> chosen, VU triangle,
                              SampleOffset sample, CulledTriangles::Pixels& out) {
  const F f;
  const I i;
  if (hn::AllFalse(i, chosen)) return;
  const DepthPlanes depth = depth_planes(t.at, t.z[0], t.z[1], t.z[2]);
  const VF px = hn::Add(hn::ConvertTo(f, c.x), hn::Set(f, sample.x.to_float()));
  const VF py = hn::Add(hn::ConvertTo(f, c.y), hn::Set(f, sample.y.to_float()));
  const Packer<I> pack(chosen);
  const auto n = static_cast<std::size_t>(out.size);
  pack.store(hn::BitCast(U(), hn::Or(hn::ShiftLeft<16>(c.y), c.x)), out.xy.data() + n);
  pack.store(depth.at(px, py), out.z.data() + n);
  pack.store(triangle, out.triangle.data() + n);
  out.size += static_cast<int>(pack.count());
}

/// Appends small triangles, finished where they cover one pixel, but those that cover none.
HWY_INLINE void append_small(const Turned& t, const Extent& ex, const Extent& ey,
                             hn::Mask<I> chosen, VU triangle, const CullLimits& limits,
                             CulledTriangles& out) {
  const I i;
  const Coverage covered = coverage(t.at, ex, ey, chosen, limits.pattern);
  const auto counts = [&](int n) HWY_ATTR {
    return hn::And(covered.is_known, hn::Eq(covered.count, hn::Set(i, n)));
  };
  auto is_done = counts(0);
  if (limits.finish_pixels) {
    append_pixels(t, covered, counts(1), triangle, limits.pattern[0], out.pixels);
    is_done = hn::Or(is_done, counts(1));
  }
  append(t, hn::AndNot(is_done, chosen), triangle, out.small);
}

HWY_INLINE void append_large(hn::Mask<I> chosen, VU triangle, CulledTriangles& out) {
  if (hn::AllFalse(I(), chosen)) return;
  const Packer<I> pack(chosen);
  pack.store(triangle, out.large_triangle.data() + out.large_size);
  out.large_size += static_cast<int>(pack.count());
}

/// @param index  three a triangle
HWY_INLINE void cull_vector(const DrawCall& call, const CullLimits& limits,
                            const std::uint32_t* index, std::uint32_t first, CulledTriangles& out) {
  const F f;
  const I i;
  const U u;
  auto drawable = first_lanes(f, hn::Lanes(f));
  const Corner a = load_corner(call.vertices.data(), index, drawable);
  const Corner b = load_corner(call.vertices.data(), index + 1, drawable);
  const Corner c = load_corner(call.vertices.data(), index + 2, drawable);
  const Extent ex = extent_of(a.x, b.x, c.x, limits.samples.least_x, limits.samples.most_x);
  const Extent ey = extent_of(a.y, b.y, c.y, limits.samples.least_y, limits.samples.most_y);
  const VI zero = hn::Zero(i), width = hn::Set(i, limits.width), height = hn::Set(i, limits.height);
  const auto touches = hn::And(hn::Lt(hn::Max(ex.first, zero), hn::Min(ex.end, width)),
                               hn::Lt(hn::Max(ey.first, zero), hn::Min(ey.end, height)));
  // Up to 64 pixels the area fits 32 bits.
  const VI extent = hn::Max(ex.raw, ey.raw);
  const auto fits = hn::Lt(extent, hn::Set(i, CulledTriangles::kMostMediumPx * 256));
  const VI area = hn::Sub(hn::Mul(hn::Sub(b.x, a.x), hn::Sub(c.y, a.y)),
                          hn::Mul(hn::Sub(c.x, a.x), hn::Sub(b.y, a.y)));
  const auto front = hn::Lt(area, zero), back = hn::Gt(area, zero);
  const auto faces = limits.mode == CullMode::kBack    ? front
                     : limits.mode == CullMode::kFront ? back
                                                       : hn::Or(front, back);
  const auto keep =
      hn::And(hn::RebindMask(i, drawable), hn::And(touches, hn::Or(faces, hn::Not(fits))));
  if (hn::AllFalse(i, keep)) return;
  // Small triangles lie within the target, so that their own edges bound every loop over them.
  const auto outside = hn::Or(hn::Or(hn::Lt(ex.first, zero), hn::Lt(ey.first, zero)),
                              hn::Or(hn::Gt(ex.end, width), hn::Gt(ey.end, height)));
  const auto below = [&](int px) HWY_ATTR { return hn::Lt(extent, hn::Set(i, px * 256)); };
  const auto fits_small = hn::AndNot(outside, hn::And(keep, below(CulledTriangles::kSmallPx)));
  // As high as the triangle is over its longer side.
  const VI thin = hn::Mul(extent, hn::Set(i, CulledTriangles::kThinPx * 256));
  const auto is_thin = hn::And(fits, hn::Lt(hn::Abs(area), thin));
  const auto fits_medium = hn::Or(below(CulledTriangles::kMediumPx), is_thin);
  const auto is_medium = hn::AndNot(fits_small, hn::And(keep, fits_medium));
  const auto is_large = hn::AndNot(fits_medium, keep);
  const VU triangle = lanes_from(u, first);
  append_large(is_large, triangle, out);
  const Turned t = turned(a, b, c, front);
  append_small(t, ex, ey, fits_small, triangle, limits, out);
  append(t, is_medium, triangle, out.medium);
}

void CullTriangles(const DrawCall& call, const CullLimits& limits, std::uint32_t first,
                   std::uint32_t count, CulledTriangles& out) {
  const U u;
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(u));
  const std::uint32_t* const index = call.indices.data() + std::size_t{3} * first;
  std::uint32_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    cull_vector(call, limits, index + std::size_t{3} * i, first + i, out);
  }
  if (i == count) return;
  // The rest, filled up with triangles of no area.
  std::array<std::uint32_t, 24> rest;
  rest.fill(index[0]);
  std::copy_n(index + std::size_t{3} * i, std::size_t{3} * (count - i), rest.begin());
  cull_vector(call, limits, rest.data(), first + i, out);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(CullTriangles);

void cull_triangles(const DrawCall& call, std::uint32_t first, std::uint32_t count,
                    std::span<const SampleOffset> pattern, const TileGrid& grid, bool finish_pixels,
                    CulledTriangles& out) {
  const CullLimits limits{pattern,    sample_limits(pattern),
                          grid.width, grid.height,
                          call.cull,  finish_pixels && pattern.size() == 1};
  out.pixels.size = out.small.size = out.medium.size = out.large_size = 0;
  HWY_DYNAMIC_DISPATCH(CullTriangles)(call, limits, first, count, out);
}

}  // namespace kinescope
#endif
