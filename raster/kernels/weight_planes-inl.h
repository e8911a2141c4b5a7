// The planes that interpolate attributes over triangles, set up for a vector of triangles at a
// time. Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_WEIGHT_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_WEIGHT_PLANES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_WEIGHT_PLANES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_WEIGHT_PLANES_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/kernels/batch_storage.h"
#include "raster/kernels/vertex_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using U16 = hn::Rebind<std::uint16_t, F>;

/// Twice the areas of triangles, rounded once: with sides of at most 2^25 raw units the products
/// and their difference are exact in double precision.
HWY_INLINE hn::Vec<F> double_area(hn::Vec<I> x1, hn::Vec<I> y1, hn::Vec<I> x2, hn::Vec<I> y2) {
  const F f;
#if HWY_TARGET == HWY_SCALAR
  const double area = static_cast<double>(hn::GetLane(x1)) * hn::GetLane(y2) -
                      static_cast<double>(hn::GetLane(x2)) * hn::GetLane(y1);
  return hn::Set(f, static_cast<float>(area));
#else
  const hn::Half<F> half;
  const hn::Half<I> half_i;
  const hn::Rebind<double, hn::Half<F> > d;
  const auto of = [&](auto a1, auto b1, auto a2, auto b2) HWY_ATTR {
    const auto wide = [&](auto v) HWY_ATTR { return hn::PromoteTo(d, v); };
    return hn::DemoteTo(half, hn::Sub(hn::Mul(wide(a1), wide(b2)), hn::Mul(wide(a2), wide(b1))));
  };
  const auto low = [&](hn::Vec<I> v) HWY_ATTR { return hn::LowerHalf(half_i, v); };
  const auto high = [&](hn::Vec<I> v) HWY_ATTR { return hn::UpperHalf(half_i, v); };
  return hn::Combine(f, of(high(x1), high(y1), high(x2), high(y2)),
                     of(low(x1), low(y1), low(x2), low(y2)));
#endif
}

/// Planes of runs [k, k + lanes).
HWY_INLINE void set_planes(const DrawCall& call, std::size_t k, WeightPlanes& p) {
  const F f;
  using V = hn::Vec<F>;
  const V raw = hn::Set(f, 256.0f), to_px = hn::Set(f, 1.0f / 256.0f);
  hn::Vec<I> x[3], y[3];
  V inv_w[3];
  HWY_UNROLL(3)
  for (std::size_t v = 0; v < 3; ++v) {
    const auto vertex = load_vertices(f, call.vertices.data(), p.vertex[v].data() + k, 1);
    x[v] = hn::NearestInt(hn::Mul(vertex.a, raw));
    y[v] = hn::NearestInt(hn::Mul(vertex.b, raw));
    inv_w[v] = vertex.d;
  }
  const auto x1 = hn::Sub(x[1], x[0]), y1 = hn::Sub(y[1], y[0]);
  const auto x2 = hn::Sub(x[2], x[0]), y2 = hn::Sub(y[2], y[0]);
  // Negative if counter-clockwise, since y runs down.
  const V scale = hn::Div(raw, double_area(x1, y1, x2, y2));
  const auto scaled = [&](hn::Vec<I> side)
                          HWY_ATTR { return hn::Mul(hn::ConvertTo(f, side), scale); };
  const V b1x = scaled(y2), b1y = hn::Neg(scaled(x2));
  const V b2x = hn::Neg(scaled(y1)), b2y = scaled(x1);
  const V rise1 = hn::Sub(inv_w[1], inv_w[0]), rise2 = hn::Sub(inv_w[2], inv_w[0]);
  const auto store = [&](V value, WeightPlanes::Runs<float>& to)
                         HWY_ATTR { hn::StoreU(value, f, to.data() + k); };
  store(hn::Mul(hn::ConvertTo(f, x[0]), to_px), p.x_px);
  store(hn::Mul(hn::ConvertTo(f, y[0]), to_px), p.y_px);
  store(inv_w[0], p.w0);
  store(hn::Mul(b1x, inv_w[1]), p.dx1);
  store(hn::Mul(b1y, inv_w[1]), p.dy1);
  store(hn::Mul(b2x, inv_w[2]), p.dx2);
  store(hn::Mul(b2y, inv_w[2]), p.dy2);
  store(hn::Add(hn::Mul(b1x, rise1), hn::Mul(b2x, rise2)), p.dx_sum);
  store(hn::Add(hn::Mul(b1y, rise1), hn::Mul(b2y, rise2)), p.dy_sum);
  store(hn::CopySign(hn::Set(f, 1.0f), hn::Neg(scale)), p.facing);
}

/// The attributes that are interpolated, a bit each.
HWY_INLINE std::uint32_t attributes_of(const DrawCall& call) {
  const int uv = call.texcoord_attribute;
  const std::uint32_t read = call.attributes_read | (uv >= 0 ? 3u << uv : 0u);
  return read & ((1u << call.attribute_count) - 1);
}

/// The same as a list.
struct AttributeList {
  explicit AttributeList(const DrawCall& call) {
    for (std::uint32_t left = attributes_of(call); left != 0; left &= left - 1) {
      index[count++] = static_cast<std::size_t>(std::countr_zero(left));
    }
  }
  std::size_t count = 0;
  std::array<std::size_t, Batch::kMaxAttributes> index;
};

/// Attributes of runs [k, k + lanes) at the first corner, and their rise to the other two.
HWY_INLINE void set_attributes(const DrawCall& call, std::size_t k, WeightPlanes& p) {
  const F f;
  const auto count = static_cast<std::size_t>(call.attribute_count);
  const auto stride = static_cast<std::size_t>(call.attribute_stride);
  const std::uint32_t wanted = attributes_of(call);
  const auto store = [&](std::size_t a, hn::Vec<F> base, hn::Vec<F> second, hn::Vec<F> third)
                         HWY_ATTR {
                           hn::StoreU(base, f, p.attribute[0][a].data() + k);
                           hn::StoreU(hn::Sub(second, base), f, p.attribute[1][a].data() + k);
                           hn::StoreU(hn::Sub(third, base), f, p.attribute[2][a].data() + k);
                         };
  std::size_t a = 0;
  for (; a < count && a + 4 <= stride; a += 4) {
    if ((wanted >> a & 15) == 0) continue;
    const float* const column = call.attributes.data() + a;
    const auto four = [&](std::size_t v) HWY_ATTR {
      const std::uint32_t* const vertex = p.vertex[v].data() + k;
      return load_fours(f, [&](std::size_t lane) { return column + vertex[lane] * stride; });
    };
    const auto base = four(0), second = four(1), third = four(2);
    store(a, base.a, second.a, third.a);
    store(a + 1, base.b, second.b, third.b);
    store(a + 2, base.c, second.c, third.c);
    if ((wanted >> a & 8) != 0) store(a + 3, base.d, second.d, third.d);
  }
  for (; a < count; ++a) {
    for (std::size_t lane = 0; lane < hn::Lanes(f); ++lane) {
      const auto at = [&](std::size_t v) {
        return call.attributes[p.vertex[v][k + lane] * stride + a];
      };
      p.attribute[0][a][k + lane] = at(0);
      p.attribute[1][a][k + lane] = at(1) - at(0);
      p.attribute[2][a][k + lane] = at(2) - at(0);
    }
  }
}

/// A texture coordinate u is N / S, both planes; its derivative is (N' - u S') / S. N' is that of
/// the two weights' planes, times the rise to their vertices, and of the sum's, times u at the
/// first.
HWY_INLINE void set_gradients(const DrawCall& call, std::size_t k, WeightPlanes& p) {
  const F f;
  const auto uv = static_cast<std::size_t>(call.texcoord_attribute);
  const auto at = [&](const WeightPlanes::Runs<float>& plane)
                      HWY_ATTR { return hn::LoadU(f, plane.data() + k); };
  for (std::size_t a = 0; a < 2; ++a) {
    const auto base = at(p.attribute[0][uv + a]);
    const auto rise1 = at(p.attribute[1][uv + a]), rise2 = at(p.attribute[2][uv + a]);
    const auto along = [&](const auto& d1, const auto& d2, const auto& sum) HWY_ATTR {
      return hn::MulAdd(at(sum), base, hn::MulAdd(at(d2), rise2, hn::Mul(at(d1), rise1)));
    };
    hn::StoreU(along(p.dx1, p.dx2, p.dx_sum), f, p.gradient[a].data() + k);
    hn::StoreU(along(p.dy1, p.dy2, p.dy_sum), f, p.gradient[2 + a].data() + k);
  }
}

/// Looks up the vertices of p.triangle[first, end), and asks for what will be read of them: where
/// triangles are tiny, waiting for memory would be the greatest part of the cost.
template <bool kWithRows>
HWY_INLINE void find_vertices(const DrawCall& call, std::size_t first, std::size_t end,
                              WeightPlanes& p) {
  const DeviceVertex* const vertices = call.vertices.data();
  const float* const rows = call.attributes.data();
  const auto stride = static_cast<std::size_t>(call.attribute_stride);
  for (std::size_t t = first; t < end; ++t) {
    const std::uint32_t* const corner = call.indices.data() + std::size_t{3} * p.triangle[t];
    const std::size_t a = corner[0], b = corner[1], c = corner[2];
    p.vertex[0][t] = corner[0];
    p.vertex[1][t] = corner[1];
    p.vertex[2][t] = corner[2];
    hwy::Prefetch(vertices + a);
    hwy::Prefetch(vertices + b);
    hwy::Prefetch(vertices + c);
    if (!kWithRows) continue;
    hwy::Prefetch(rows + a * stride);
    hwy::Prefetch(rows + b * stride);
    hwy::Prefetch(rows + c * stride);
  }
}

/// Sets up the planes of p.triangle[first, end); those of some entries beyond are overwritten.
HWY_INLINE void set_up_triangles(const DrawCall& call, std::size_t first, std::size_t end,
                                 WeightPlanes& p) {
  const std::size_t lanes = hn::Lanes(F());
  if (attributes_of(call) != 0) {
    find_vertices<true>(call, first, end, p);
  } else {
    find_vertices<false>(call, first, end, p);
  }
  // Whole vectors of vertices that exist.
  for (auto& vertex : p.vertex) std::fill_n(vertex.begin() + end, lanes - 1, vertex[first]);
  for (std::size_t k = first; k < end; k += lanes) {
    set_planes(call, k, p);
    set_attributes(call, k, p);
    if (call.texcoord_attribute >= 0) set_gradients(call, k, p);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_WEIGHT_PLANES_INL_H_
