// Set-up of triangles, SIMD across them: the same operations as set_up_triangle's, in its order.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_SET_UP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_SET_UP_INL_H_
#undef KINESCOPE_RASTER_KERNELS_SET_UP_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_SET_UP_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "raster/base/fixed.h"
#include "raster/bins.h"
#include "raster/kernels/vertex_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;
using VU = hn::Vec<U>;

/// Raw Fixed24_8 vertices of several triangles of positive area, at most 64 pixels either way.
struct Corners {
  VI x[3], y[3];
};

/// Triangles as bins hold them.
struct Binned {
  Corners at;
  VF z[3];
  VU id;
};

/// Of a tile's triangles [k, k + lanes); the last one for those that are not there.
/// @param x0,y0  the tile's first pixel
HWY_INLINE Binned load_binned(const TriangleChunk& t, std::size_t k, int x0, int y0) {
  const F f;
  const I i;
  const U u;
  const auto last = static_cast<std::size_t>(t.size - 1);
  const auto row = [&](std::size_t j) { return t.triangle[std::min(k + j, last)].word.data(); };
  const auto low = load_fours(u, row);
  const auto high = load_fours(u, [&](std::size_t j) { return row(j) + 4; });
  const VI tile_x = hn::Set(i, x0 * Fixed24_8::kOne), tile_y = hn::Set(i, y0 * Fixed24_8::kOne);
  const auto x = [&](VU xy) HWY_ATTR {
    return hn::Add(hn::ShiftRight<16>(hn::BitCast(i, hn::ShiftLeft<16>(xy))), tile_x);
  };
  const auto y = [&](VU xy)
                     HWY_ATTR { return hn::Add(hn::ShiftRight<16>(hn::BitCast(i, xy)), tile_y); };
  return {{{x(low.a), x(low.b), x(low.c)}, {y(low.a), y(low.b), y(low.c)}},
          {hn::BitCast(f, low.d), hn::BitCast(f, high.a), hn::BitCast(f, high.b)},
          high.c};
}

HWY_INLINE VI least(const VI (&v)[3]) { return hn::Min(hn::Min(v[0], v[1]), v[2]); }
HWY_INLINE VI most(const VI (&v)[3]) { return hn::Max(hn::Max(v[0], v[1]), v[2]); }

/// The first pixel that may have a sample at a raw place or behind it, and the last one before it.
HWY_INLINE VI first_pixel(VI raw, Fixed24_8 most_offset) {
  return hn::ShiftRight<8>(hn::Add(raw, hn::Set(I(), 255 - most_offset.raw())));
}
HWY_INLINE VI last_pixel(VI raw, Fixed24_8 least_offset) {
  return hn::ShiftRight<8>(hn::Sub(raw, hn::Set(I(), least_offset.raw())));
}

/// The edge from vertex `v` to the next: its sides, and E with the top-left bias at a point within
/// a pixel of the triangle's box, in raw units squared.
struct Edge {
  VI dx, dy, e;
};

HWY_INLINE Edge edge_at(const Corners& c, int v, VI point_x, VI point_y) {
  const I i;
  const int next = v == 2 ? 0 : v + 1;
  const VI dx = hn::Sub(c.x[next], c.x[v]), dy = hn::Sub(c.y[next], c.y[v]), zero = hn::Zero(i);
  const auto top_left = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
  const VI e =
      hn::Sub(hn::Mul(dx, hn::Sub(point_y, c.y[v])), hn::Mul(dy, hn::Sub(point_x, c.x[v])));
  return {dx, dy, hn::Sub(e, hn::IfThenZeroElse(top_left, hn::Set(i, 1)))};
}

/// DepthPlane, of several triangles.
struct DepthPlanes {
  VF x_px, y_px, z, dz_dx, dz_dy, nearest, farthest;

  /// DepthPlane::at, with its roundings.
  HWY_INLINE VF at(VF px, VF py) const {
    const VF row = hn::Add(z, hn::Mul(dz_dy, hn::Sub(py, y_px)));
    const VF plane = hn::Add(row, hn::Mul(dz_dx, hn::Sub(px, x_px)));
    return hn::Min(hn::Max(plane, nearest), farthest);
  }
};

HWY_INLINE DepthPlanes depth_planes(const Corners& c, VF z0, VF z1, VF z2) {
  const F f;
  const VI x1 = hn::Sub(c.x[1], c.x[0]), y1 = hn::Sub(c.y[1], c.y[0]);
  const VI x2 = hn::Sub(c.x[2], c.x[0]), y2 = hn::Sub(c.y[2], c.y[0]);
  const VF z10 = hn::Sub(z1, z0), z20 = hn::Sub(z2, z0);
  const VI area = hn::Sub(hn::Mul(x1, y2), hn::Mul(x2, y1));
  const VF inverse = hn::Div(hn::Set(f, 1.0f), hn::ConvertTo(f, area));
  const VF num_x = hn::Sub(hn::Mul(z10, hn::ConvertTo(f, y2)), hn::Mul(z20, hn::ConvertTo(f, y1)));
  const VF num_y = hn::Sub(hn::Mul(z20, hn::ConvertTo(f, x1)), hn::Mul(z10, hn::ConvertTo(f, x2)));
  const VF to_px = hn::Set(f, 1.0f / 256.0f), a_pixel = hn::Set(f, 256.0f);
  return {hn::Mul(hn::ConvertTo(f, c.x[0]), to_px),
          hn::Mul(hn::ConvertTo(f, c.y[0]), to_px),
          z0,
          hn::Mul(hn::Mul(num_x, inverse), a_pixel),
          hn::Mul(hn::Mul(num_y, inverse), a_pixel),
          hn::Min(hn::Min(z0, z1), z2),
          hn::Max(hn::Max(z0, z1), z2)};
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_SET_UP_INL_H_
