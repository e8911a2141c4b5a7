#include "raster/kernels/interpolate.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/interpolate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/pack-inl.h"
#include "raster/kernels/weight_planes-inl.h"
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Values of eight consecutive runs at most, for fragments that belong to them.
struct RunWindow {
  std::size_t first;
  decltype(hn::IndicesFromVec(F(), hn::Vec<I>())) within;
  HWY_INLINE hn::Vec<F> operator()(const WeightPlanes::Runs<float>& plane) const {
    return hn::TableLookupLanes(hn::LoadU(F(), plane.data() + first), within);
  }
};
/// The same of twice as many runs.
struct TwoWindows {
  RunWindow low, high;
  hn::Mask<F> in_high;
  HWY_INLINE hn::Vec<F> operator()(const WeightPlanes::Runs<float>& plane) const {
    return hn::IfThenElse(in_high, high(plane), low(plane));
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
  for (std::size_t a = 0; a < 2; ++a) {
    const V place = hn::Load(f, batch.attribute[uv + a].data() + k);
    const V along_x = hn::NegMulAdd(place, of(p.dx_sum), of(p.gradient[a]));
    const V along_y = hn::NegMulAdd(place, of(p.dy_sum), of(p.gradient[2 + a]));
    hn::Store(hn::Mul(inverse, along_x), f, batch.gradient[a].data() + k);
    hn::Store(hn::Mul(inverse, along_y), f, batch.gradient[2 + a].data() + k);
  }
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

/// Rows of a block, and blocks, meet the same triangles again and again: a run of [first, end)
/// whose triangle had one before joins it.
/// @param count  runs left of those before. @return runs left of all
HWY_INLINE std::size_t join_runs(const DrawCall& call, std::size_t first, std::size_t end,
                                 std::size_t count, WeightPlanes& p) {
  for (std::size_t r = first; r < end; ++r) {
    const std::uint32_t triangle = p.triangle[r];
    hwy::Prefetch(call.indices.data() + std::size_t{3} * triangle);
    std::uint16_t& place = p.place[triangle % p.place.size()];
    const bool is_new = place >= count || p.triangle[place] != triangle;
    // No branch: nobody can predict which triangle comes next.
    const std::size_t at = is_new ? count : place;
    p.triangle[at] = triangle;
    place = static_cast<std::uint16_t>(at);
    p.joined[r] = static_cast<std::int32_t>(at);
    count += is_new ? 1 : 0;
  }
  return count;
}

/// Runs [first, end) as they are, behind `count` others. @return runs left of all
HWY_INLINE std::size_t keep_runs(const DrawCall& call, std::size_t first, std::size_t end,
                                 std::size_t count, WeightPlanes& p) {
  const I i;
  const U u;
  const std::size_t lanes = hn::Lanes(i);
  for (std::size_t r = first; r < end; ++r) {
    hwy::Prefetch(call.indices.data() + std::size_t{3} * p.triangle[r]);
  }
  for (std::size_t r = first; r < end; r += lanes) {
    const std::size_t at = count + r - first;
    hn::StoreU(hn::LoadU(u, p.triangle.data() + r), u, p.triangle.data() + at);
    hn::StoreU(lanes_from(i, static_cast<std::int32_t>(at)), i, p.joined.data() + r);
  }
  return count + end - first;
}

/// The triangles to set up for a batch. @return how many
HWY_INLINE std::size_t find_triangles(const DrawCall& call, std::size_t size, BatchStorage& batch) {
  constexpr std::size_t kTried = 32, kFew = kTried / 4;
  WeightPlanes& p = batch.planes;
  const std::size_t runs = find_runs(size, batch), tried = std::min(runs, kTried);
  const std::size_t count = join_runs(call, 0, tried, 0, p);
  // Triangles of a pixel or two come again so seldom that to look for them costs more.
  return count + kFew > tried ? keep_runs(call, tried, runs, count, p)
                              : join_runs(call, tried, runs, count, p);
}

/// A vector of fragments of several runs.
/// @param run  of each fragment
HWY_INLINE void interpolate_runs(const DrawCall& call, const AttributeList& list, std::size_t k,
                                 hn::Vec<I> run, BatchStorage& batch) {
  const F f;
  const I i;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(i));
  const std::int32_t least = hn::GetLane(hn::MinOfLanes(i, run));
  const std::int32_t span = hn::GetLane(hn::MaxOfLanes(i, run)) - least;
  if (span >= 2 * lanes) return interpolate_vector(call, list, k, AnyRuns{run}, batch);
  const auto from_least = hn::Sub(run, hn::Set(i, least));
  const auto within = hn::IndicesFromVec(f, hn::And(from_least, hn::Set(i, lanes - 1)));
  const RunWindow low{static_cast<std::size_t>(least), within};
  if (span < lanes) return interpolate_vector(call, list, k, low, batch);
  const RunWindow high{static_cast<std::size_t>(least + lanes), within};
  const auto in_high = hn::RebindMask(f, hn::Gt(from_least, hn::Set(i, lanes - 1)));
  interpolate_vector(call, list, k, TwoWindows{low, high, in_high}, batch);
}

/// All vectors of fragments, with the planes of their runs.
HWY_INLINE void interpolate_all(const DrawCall& call, const AttributeList& list, std::size_t size,
                                BatchStorage& batch) {
  const I i;
  const hn::Rebind<std::uint8_t, I> u8;
  const std::size_t lanes = hn::Lanes(i);
  const WeightPlanes& p = batch.planes;
  for (std::size_t k = 0, v = 0; k < size; k += lanes, ++v) {
    const std::int32_t* const joined = p.joined.data() + p.first_run[v];
    const std::uint32_t ends = p.run_ends[v] & ((1u << (lanes - 1)) - 1);
    if (ends == 0) {
      interpolate_vector(call, list, k, OneRun{static_cast<std::size_t>(joined[0])}, batch);
      continue;
    }
    const auto within = hn::PromoteTo(i, hn::LoadU(u8, kBitsBefore[ends].data()));
    const auto run = hn::TableLookupLanes(hn::LoadU(i, joined), hn::IndicesFromVec(i, within));
    interpolate_runs(call, list, k, run, batch);
  }
}

void Interpolate(const DrawCall& call, int size, BatchStorage& batch) {
  const AttributeList list(call);
  if (list.count == 0 && call.cull != CullMode::kNone) return;
  const auto end = static_cast<std::size_t>(size);
  set_up_triangles(call, 0, find_triangles(call, end, batch), batch.planes);
  interpolate_all(call, list, end, batch);
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
