#include "raster/kernels/interpolate.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/interpolate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/pack-inl.h"
#include "raster/tile.h"

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
  const I i;
  const U u;
  using V = hn::Vec<F>;
  const DeviceVertices& from = call.vertices;
  const V raw = hn::Set(f, 256.0f), to_px = hn::Set(f, 1.0f / 256.0f);
  hn::Vec<I> x[3], y[3];
  V inv_w[3];
  for (std::size_t v = 0; v < 3; ++v) {
    const auto vertex = hn::BitCast(i, hn::LoadU(u, p.vertex[v].data() + k));
    const auto snap = [&](std::span<const float> px) HWY_ATTR {
      return hn::NearestInt(hn::Mul(hn::GatherIndex(f, px.data(), vertex), raw));
    };
    x[v] = snap(from.x_px);
    y[v] = snap(from.y_px);
    inv_w[v] = hn::GatherIndex(f, from.inv_w.data(), vertex);
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

#if HWY_TARGET != HWY_SCALAR  // has no vectors of four
/// Four floats of one row in the low half of a vector, of another in the high; of the first alone
/// where vectors are of four.
template <class D>
HWY_INLINE hn::Vec<D> load_fours(D d, const float* low, const float* high) {
  const hn::FixedTag<float, 4> four;
  if constexpr (hn::MaxLanes(D()) == 8) {
    return hn::Combine(d, hn::LoadU(four, high), hn::LoadU(four, low));
  } else {
    return hn::LoadU(d, low);
  }
}
#endif

/// The attributes that are interpolated, a bit each.
HWY_INLINE std::uint32_t attributes_of(const DrawCall& call) {
  return call.attributes_read & ((1u << call.attribute_count) - 1);
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

/// One corner's rows of attributes of runs [k, k + lanes), turned into planes: to[a][k + lane].
HWY_INLINE void transpose_rows(const DrawCall& call, std::size_t v, std::size_t k,
                               WeightPlanes& p) {
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const auto count = static_cast<std::size_t>(call.attribute_count);
  const auto stride = static_cast<std::size_t>(call.attribute_stride);
  const float* row[8];
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    row[lane] = call.attributes.data() + p.vertex[v][k + lane] * stride;
  }
  WeightPlanes::Attributes& to = p.attribute[v];
  std::size_t a = 0;
#if HWY_TARGET != HWY_SCALAR  // has no vectors of four
  const hn::RepartitionToWide<F> pairs;
  const auto load = [&](std::size_t j)
                        HWY_ATTR { return load_fours(f, row[j] + a, row[j + lanes - 4] + a); };
  const auto store = [&](auto value, std::size_t at)
                         HWY_ATTR { hn::Store(hn::BitCast(f, value), f, to[at].data() + k); };
  for (; a < count && a + 4 <= stride; a += 4) {
    if ((attributes_of(call) >> a & 15) == 0) continue;
    const auto r0 = load(0), r1 = load(1), r2 = load(2), r3 = load(3);
    const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(f, r0, r1));
    const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(f, r2, r3));
    const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(f, r0, r1));
    const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(f, r2, r3));
    store(hn::InterleaveLower(pairs, low01, low23), a);
    store(hn::InterleaveUpper(pairs, low01, low23), a + 1);
    store(hn::InterleaveLower(pairs, high01, high23), a + 2);
    store(hn::InterleaveUpper(pairs, high01, high23), a + 3);
  }
#endif
  for (; a < count; ++a) {
    for (std::size_t lane = 0; lane < lanes; ++lane) to[a][k + lane] = row[lane][a];
  }
}

/// Attributes of runs [k, k + lanes) at the first corner, and their rise to the other two.
HWY_INLINE void set_attributes(const DrawCall& call, const AttributeList& list, std::size_t k,
                               WeightPlanes& p) {
  const F f;
  for (std::size_t v = 0; v < 3; ++v) transpose_rows(call, v, k, p);
  for (std::size_t n = 0; n < list.count; ++n) {
    const std::size_t a = list.index[n];
    const auto base = hn::Load(f, p.attribute[0][a].data() + k);
    for (std::size_t v = 1; v < 3; ++v) {
      float* const at = p.attribute[v][a].data() + k;
      hn::Store(hn::Sub(hn::Load(f, at), base), f, at);
    }
  }
}

/// Values of eight consecutive runs at most, for fragments that belong to them.
struct RunWindow {
  std::size_t first;
  decltype(hn::IndicesFromVec(F(), hn::Vec<I>())) within;
  HWY_INLINE hn::Vec<F> operator()(const WeightPlanes::Runs<float>& plane) const {
    return hn::TableLookupLanes(hn::LoadU(F(), plane.data() + first), within);
  }
};
/// Values of one run.
struct OneRun {
  std::size_t run;
  HWY_INLINE hn::Vec<F> operator()(const WeightPlanes::Runs<float>& plane) const {
    return hn::Set(F(), plane[run]);
  }
};
/// Values of any runs.
struct AnyRuns {
  hn::Vec<I> run;
  HWY_INLINE hn::Vec<F> operator()(const WeightPlanes::Runs<float>& plane) const {
    return hn::GatherIndex(F(), plane.data(), run);
  }
};

/// Fragments [k, k + lanes).
/// @param of  gives each fragment the value of its run
template <class Of>
HWY_NOINLINE void interpolate_vector(const DrawCall& call, const AttributeList& list, std::size_t k,
                                     const Of& of, BatchStorage& batch) {
  const F f;
  const I i;
  const U16 u16;
  using V = hn::Vec<F>;
  const auto half = hn::Set(f, 0.5f), zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const WeightPlanes& p = batch.planes;
  const V px = hn::ConvertTo(f, hn::PromoteTo(i, hn::LoadU(u16, batch.x.data() + k)));
  const V py = hn::ConvertTo(f, hn::PromoteTo(i, hn::LoadU(u16, batch.y.data() + k)));
  const V dx = hn::Sub(hn::Add(px, half), of(p.x_px));
  const V dy = hn::Sub(hn::Add(py, half), of(p.y_px));
  const V sum = hn::MulAdd(dx, of(p.dx_sum), hn::MulAdd(dy, of(p.dy_sum), of(p.w0)));
  const V inverse = hn::Div(one, sum);
  const V raw1 = hn::MulAdd(dx, of(p.dx1), hn::Mul(dy, of(p.dy1)));
  const V raw2 = hn::MulAdd(dx, of(p.dx2), hn::Mul(dy, of(p.dy2)));
  const V w1 = hn::Min(hn::Max(hn::Mul(raw1, inverse), zero), one);
  const V w2 = hn::Min(hn::Max(hn::Mul(raw2, inverse), zero), hn::Sub(one, w1));
  for (std::size_t n = 0; n < list.count; ++n) {
    const std::size_t a = list.index[n];
    const V value = hn::MulAdd(w2, of(p.attribute[2][a]),
                               hn::MulAdd(w1, of(p.attribute[1][a]), of(p.attribute[0][a])));
    hn::Store(value, f, batch.attribute[a].data() + k);
  }
  if (call.cull == CullMode::kNone) hn::Store(of(p.facing), f, batch.facing.data() + k);
  if (call.texcoord_attribute < 0) return;
  const auto uv = static_cast<std::size_t>(call.texcoord_attribute);
  const auto gradient = [&](V d1, V d2, V dsum, std::size_t out) HWY_ATTR {
    // The derivative of weight / sum.
    const V g1 = hn::Mul(inverse, hn::NegMulAdd(w1, dsum, d1));
    const V g2 = hn::Mul(inverse, hn::NegMulAdd(w2, dsum, d2));
    for (std::size_t a = 0; a < 2; ++a) {
      const V value =
          hn::MulAdd(g2, of(p.attribute[2][uv + a]), hn::Mul(g1, of(p.attribute[1][uv + a])));
      hn::Store(value, f, batch.gradient[out + a].data() + k);
    }
  };
  gradient(of(p.dx1), of(p.dx2), of(p.dx_sum), 0);
  gradient(of(p.dy1), of(p.dy2), of(p.dy_sum), 2);
}

/// Finds the runs; returns how many there are.
HWY_INLINE std::size_t find_runs(std::size_t size, BatchStorage& batch) {
  const U u;
  const std::size_t lanes = hn::Lanes(u);
  WeightPlanes& p = batch.planes;
  // So that the last fragment and those beyond it are of one run.
  for (std::size_t k = size; k <= size + lanes; ++k) batch.triangle[k] = batch.triangle[size - 1];
  p.triangle[0] = batch.triangle[0];
  std::int32_t run = 0;
  for (std::size_t k = 0, v = 0; k < size; k += lanes, ++v) {
    const auto next = hn::LoadU(u, batch.triangle.data() + k + 1);
    const Packer<U> pack(hn::Ne(hn::Load(u, batch.triangle.data() + k), next));
    pack.store(next, p.triangle.data() + run + 1);
    p.first_run[v] = run;
    p.run_ends[v] = pack.bits();
    run += static_cast<std::int32_t>(pack.count());
  }
  return static_cast<std::size_t>(run) + 1;
}

/// Rows of a block meet the same few triangles again and again: a run whose triangle is that of one
/// of the last four joins it. @return how many runs are left
HWY_INLINE std::size_t join_runs(std::size_t runs, WeightPlanes& p) {
  // The last four, in registers: memory written a moment ago would be waited for. No branch asks
  // whether one of them is it: nobody can predict that.
  std::uint32_t last0, last1, last2, last3;
  last0 = last1 = last2 = last3 = TileBuffer::kNothing;
  std::uint32_t count = 0;
  for (std::size_t r = 0; r < runs; ++r) {
    const std::uint32_t triangle = p.triangle[r];
    const std::uint32_t same = (triangle == last0 ? 1u : 0u) | (triangle == last1 ? 2u : 0u) |
                               (triangle == last2 ? 4u : 0u) | (triangle == last3 ? 8u : 0u);
    const auto back = static_cast<std::uint32_t>(std::countr_zero(same));
    const bool is_new = same == 0;
    const std::uint32_t at = is_new ? count : count - 1 - back;
    const std::uint32_t changed = is_new ? ~0u : 0u;
    last3 ^= (last3 ^ last2) & changed;
    last2 ^= (last2 ^ last1) & changed;
    last1 ^= (last1 ^ last0) & changed;
    last0 ^= (last0 ^ triangle) & changed;
    p.triangle[at] = triangle;
    p.joined[r] = static_cast<std::int32_t>(at);
    count += is_new ? 1 : 0;
  }
  return count;
}

/// All vectors of fragments, with the planes of their runs.
HWY_INLINE void interpolate_all(const DrawCall& call, const AttributeList& list, std::size_t size,
                                bool joined, BatchStorage& batch) {
  const I i;
  const U u;
  const hn::Rebind<std::uint8_t, F> u8;
  const std::size_t lanes = hn::Lanes(u);
  const WeightPlanes& p = batch.planes;
  for (std::size_t k = 0, v = 0; k < size; k += lanes, ++v) {
    const auto first = static_cast<std::size_t>(p.first_run[v]);
    const std::uint32_t ends = p.run_ends[v] & ((1u << (lanes - 1)) - 1);
    if (ends == 0) {
      interpolate_vector(call, list, k,
                         OneRun{joined ? static_cast<std::size_t>(p.joined[first]) : first}, batch);
      continue;
    }
    const auto within = hn::PromoteTo(u, hn::LoadU(u8, kBitsBefore[ends].data()));
    if (!joined) {
      interpolate_vector(call, list, k, RunWindow{first, hn::IndicesFromVec(F(), within)}, batch);
      continue;
    }
    const auto run =
        hn::TableLookupLanes(hn::LoadU(i, p.joined.data() + first), hn::IndicesFromVec(i, within));
    const std::int32_t least = hn::GetLane(hn::MinOfLanes(i, run));
    const std::int32_t most = hn::GetLane(hn::MaxOfLanes(i, run));
    if (most - least < static_cast<std::int32_t>(lanes)) {
      const auto from_least = hn::IndicesFromVec(F(), hn::Sub(run, hn::Set(i, least)));
      interpolate_vector(call, list, k, RunWindow{static_cast<std::size_t>(least), from_least},
                         batch);
    } else {
      interpolate_vector(call, list, k, AnyRuns{run}, batch);
    }
  }
}

/// Looks up the runs' vertices, and asks for what will be read of them: where triangles are tiny,
/// waiting for memory would be the greatest part of the cost.
HWY_INLINE void find_vertices(const DrawCall& call, std::size_t runs, WeightPlanes& p) {
  constexpr std::size_t kAhead = 16;
  const std::uint32_t attributes = attributes_of(call);
  const DeviceVertices& from = call.vertices;
  const auto stride = static_cast<std::size_t>(call.attribute_stride);
  const auto corners = [&](std::size_t r) {
    return call.indices.data() + std::size_t{3} * p.triangle[r];
  };
  for (std::size_t r = 0; r < std::min(runs, kAhead); ++r) hwy::Prefetch(corners(r));
  for (std::size_t r = 0; r < runs; ++r) {
    hwy::Prefetch(corners(std::min(r + kAhead, runs - 1)));
    const std::uint32_t* const corner = corners(r);
    for (std::size_t v = 0; v < 3; ++v) {
      const std::size_t vertex = corner[v];
      p.vertex[v][r] = corner[v];
      hwy::Prefetch(from.x_px.data() + vertex);
      hwy::Prefetch(from.y_px.data() + vertex);
      hwy::Prefetch(from.inv_w.data() + vertex);
      if (attributes != 0) hwy::Prefetch(call.attributes.data() + vertex * stride);
    }
  }
}

void Interpolate(const DrawCall& call, int size, BatchStorage& batch) {
  const AttributeList list(call);
  if (list.count == 0 && call.cull != CullMode::kNone) return;
  WeightPlanes& p = batch.planes;
  const auto end = static_cast<std::size_t>(size);
  const std::size_t lanes = hn::Lanes(F());
  std::size_t runs = find_runs(end, batch);
  const bool joined = 2 * runs < end;
  if (joined) runs = join_runs(runs, p);
  // Whole vectors of triangles that exist.
  const std::size_t padded = (runs + lanes - 1) / lanes * lanes;
  std::fill(p.triangle.begin() + static_cast<std::ptrdiff_t>(runs),
            p.triangle.begin() + static_cast<std::ptrdiff_t>(padded), p.triangle[0]);
  find_vertices(call, padded, p);
  for (std::size_t k = 0; k < runs; k += lanes) {
    set_planes(call, k, p);
    set_attributes(call, list, k, p);
  }
  interpolate_all(call, list, end, joined, batch);
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
