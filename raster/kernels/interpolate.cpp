#include "raster/kernels/interpolate.h"

#include <span>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/interpolate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using U16 = hn::Rebind<std::uint16_t, F>;

/// Planes of runs [k, k + lanes).
HWY_INLINE void set_planes(const DrawCall& call, std::size_t k, WeightPlanes& p) {
  const F f;
  const I i;
  const U u;
  using V = hn::Vec<F>;
  const DeviceVertices& from = call.vertices;
  const auto* const indices = reinterpret_cast<const std::int32_t*>(call.indices.data());
  const auto triangle = hn::BitCast(i, hn::LoadU(u, p.triangle.data() + k));
  const auto at = hn::Add(triangle, hn::Add(triangle, triangle));
  HWY_ALIGN std::array<std::array<std::int32_t, 8>, 3> x, y;
  V inv_w[3];
  for (std::size_t v = 0; v < 3; ++v) {
    const auto vertex = hn::GatherIndex(i, indices, hn::Add(at, hn::Set(i, static_cast<int>(v))));
    hn::StoreU(hn::BitCast(u, vertex), u, p.vertex[v].data() + k);
    const auto scale = hn::Set(f, 256.0f);
    const auto snap = [&](std::span<const float> px) HWY_ATTR {
      return hn::NearestInt(hn::Mul(hn::GatherIndex(f, px.data(), vertex), scale));
    };
    hn::Store(snap(from.x_px), i, x[v].data());
    hn::Store(snap(from.y_px), i, y[v].data());
    inv_w[v] = hn::GatherIndex(f, from.inv_w.data(), vertex);
  }
  // Twice the area needs 50 bits. It is negative if counter-clockwise, since y runs down.
  HWY_ALIGN std::array<float, 8> area;
  for (std::size_t lane = 0; lane < hn::Lanes(f); ++lane) {
    const std::int64_t x1 = x[1][lane] - x[0][lane], y1 = y[1][lane] - y[0][lane];
    const std::int64_t x2 = x[2][lane] - x[0][lane], y2 = y[2][lane] - y[0][lane];
    area[lane] = static_cast<float>(x1 * y2 - x2 * y1);
  }
  const auto side = [&](const std::array<std::array<std::int32_t, 8>, 3>& c,
                        std::size_t v) HWY_ATTR {
    return hn::ConvertTo(f, hn::Sub(hn::Load(i, c[v].data()), hn::Load(i, c[0].data())));
  };
  const V scale = hn::Div(hn::Set(f, 256.0f), hn::Load(f, area.data()));
  const V b1x = hn::Mul(side(y, 2), scale), b1y = hn::Neg(hn::Mul(side(x, 2), scale));
  const V b2x = hn::Neg(hn::Mul(side(y, 1), scale)), b2y = hn::Mul(side(x, 1), scale);
  const V rise1 = hn::Sub(inv_w[1], inv_w[0]), rise2 = hn::Sub(inv_w[2], inv_w[0]);
  const V to_px = hn::Set(f, 1.0f / 256.0f);
  const auto store = [&](V value, WeightPlanes::Runs<float>& to)
                         HWY_ATTR { hn::StoreU(value, f, to.data() + k); };
  store(hn::Mul(hn::ConvertTo(f, hn::Load(i, x[0].data())), to_px), p.x_px);
  store(hn::Mul(hn::ConvertTo(f, hn::Load(i, y[0].data())), to_px), p.y_px);
  store(inv_w[0], p.w0);
  store(hn::Mul(b1x, inv_w[1]), p.dx1);
  store(hn::Mul(b1y, inv_w[1]), p.dy1);
  store(hn::Mul(b2x, inv_w[2]), p.dx2);
  store(hn::Mul(b2y, inv_w[2]), p.dy2);
  store(hn::Add(hn::Mul(b1x, rise1), hn::Mul(b2x, rise2)), p.dx_sum);
  store(hn::Add(hn::Mul(b1y, rise1), hn::Mul(b2y, rise2)), p.dy_sum);
  store(hn::CopySign(hn::Set(f, 1.0f), hn::Neg(scale)), p.facing);
}

/// Fragments [first, end) of one triangle, in whole vectors: what is written past the end belongs
/// to the next run, or to the padding.
HWY_INLINE void interpolate_run(const DrawCall& call, std::size_t run, int first, int end,
                                BatchStorage& batch) {
  const F f;
  const I i;
  const U16 u16;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const auto half = hn::Set(f, 0.5f), zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const int uv = call.texcoord_attribute;
  const WeightPlanes& p = batch.planes;
  const auto row = [&](std::size_t v) {
    return call.attributes.data() +
           std::size_t{p.vertex[v][run]} * static_cast<unsigned>(call.attribute_stride);
  };
  const float *const row0 = row(0), *const row1 = row(1), *const row2 = row(2);
  for (int k = first; k < end; k += lanes) {
    const auto px = hn::ConvertTo(f, hn::PromoteTo(i, hn::LoadU(u16, batch.x.data() + k)));
    const auto py = hn::ConvertTo(f, hn::PromoteTo(i, hn::LoadU(u16, batch.y.data() + k)));
    const auto dx = hn::Sub(hn::Add(px, half), hn::Set(f, p.x_px[run]));
    const auto dy = hn::Sub(hn::Add(py, half), hn::Set(f, p.y_px[run]));
    const auto sum = hn::MulAdd(dx, hn::Set(f, p.dx_sum[run]),
                                hn::MulAdd(dy, hn::Set(f, p.dy_sum[run]), hn::Set(f, p.w0[run])));
    const auto inverse = hn::Div(one, sum);
    const auto raw1 = hn::MulAdd(dx, hn::Set(f, p.dx1[run]), hn::Mul(dy, hn::Set(f, p.dy1[run])));
    const auto raw2 = hn::MulAdd(dx, hn::Set(f, p.dx2[run]), hn::Mul(dy, hn::Set(f, p.dy2[run])));
    const auto w1 = hn::Min(hn::Max(hn::Mul(raw1, inverse), zero), one);
    const auto w2 = hn::Min(hn::Max(hn::Mul(raw2, inverse), zero), hn::Sub(one, w1));
    for (int a = 0; a < call.attribute_count; ++a) {
      const float a0 = row0[a];
      const auto d1 = hn::Set(f, row1[a] - a0), d2 = hn::Set(f, row2[a] - a0);
      const auto value = hn::MulAdd(w2, d2, hn::MulAdd(w1, d1, hn::Set(f, a0)));
      hn::StoreU(value, f, batch.attribute[static_cast<std::size_t>(a)].data() + k);
    }
    if (call.cull == CullMode::kNone) {
      hn::StoreU(hn::Set(f, p.facing[run]), f, batch.facing.data() + k);
    }
    if (uv < 0) continue;
    const auto gradient = [&](float d1, float d2, float dsum, std::size_t u_at, std::size_t v_at) {
      // The derivative of weight / sum.
      const auto g1 = hn::Mul(inverse, hn::NegMulAdd(w1, hn::Set(f, dsum), hn::Set(f, d1)));
      const auto g2 = hn::Mul(inverse, hn::NegMulAdd(w2, hn::Set(f, dsum), hn::Set(f, d2)));
      for (int a = 0; a < 2; ++a) {
        const float a0 = row0[uv + a];
        const auto value = hn::MulAdd(g2, hn::Set(f, row2[uv + a] - a0),
                                      hn::Mul(g1, hn::Set(f, row1[uv + a] - a0)));
        hn::StoreU(value, f, batch.gradient[a == 0 ? u_at : v_at].data() + k);
      }
    };
    gradient(p.dx1[run], p.dx2[run], p.dx_sum[run], 0, 1);
    gradient(p.dy1[run], p.dy2[run], p.dy_sum[run], 2, 3);
  }
}

void Interpolate(const DrawCall& call, int size, BatchStorage& batch) {
  WeightPlanes& p = batch.planes;
  std::size_t runs = 0;
  for (int i = 0; i < size; ++i) {
    const std::uint32_t triangle = batch.triangle[static_cast<std::size_t>(i)];
    if (runs > 0 && p.triangle[runs - 1] == triangle) continue;
    p.triangle[runs] = triangle;
    p.first[runs++] = i;
  }
  p.first[runs] = size;
  const std::size_t lanes = hn::Lanes(F());
  // Whole vectors of triangles that exist.
  for (std::size_t k = runs; k % lanes != 0; ++k) p.triangle[k] = p.triangle[0];
  for (std::size_t k = 0; k < runs; k += lanes) set_planes(call, k, p);
  for (std::size_t run = 0; run < runs; ++run) {
    interpolate_run(call, run, p.first[run], p.first[run + 1], batch);
  }
}

void UnpackFragments(const std::uint32_t* id, const std::uint32_t* xy, std::uint32_t first_id,
                     int size, BatchStorage& batch) {
  const U u;
  const I i;
  const U16 u16;
  const auto first = hn::Set(u, first_id), low = hn::Set(u, 0xffff);
  for (std::size_t k = 0; k < static_cast<std::size_t>(size); k += hn::Lanes(u)) {
    const auto both = hn::LoadU(u, xy + k);
    hn::StoreU(hn::DemoteTo(u16, hn::BitCast(i, hn::And(both, low))), u16, batch.x.data() + k);
    hn::StoreU(hn::DemoteTo(u16, hn::BitCast(i, hn::ShiftRight<16>(both))), u16,
               batch.y.data() + k);
    hn::StoreU(hn::Sub(hn::LoadU(u, id + k), first), u, batch.triangle.data() + k);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(Interpolate);
HWY_EXPORT(UnpackFragments);

void interpolate(const DrawCall& call, int size, BatchStorage& batch) {
  HWY_DYNAMIC_DISPATCH(Interpolate)(call, size, batch);
}

void unpack_fragments(const std::uint32_t* id, const std::uint32_t* xy, std::uint32_t first_id,
                      int size, BatchStorage& batch) {
  HWY_DYNAMIC_DISPATCH(UnpackFragments)(id, xy, first_id, size, batch);
}

}  // namespace kinescope
#endif
