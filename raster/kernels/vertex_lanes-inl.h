// Rows of four numbers, one a lane, turned into four vectors and back: vertices and binned
// triangles lie that way in memory. Included once for each instruction set, hence the unusual
// guard.
#if defined(KINESCOPE_RASTER_KERNELS_VERTEX_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_VERTEX_LANES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_VERTEX_LANES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_VERTEX_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raster/device_vertex.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct FourVectors {
  V a, b, c, d;
};

/// Loads four numbers of 32 bits for each lane, at most eight of them, and transposes.
/// @param row  the address of a lane's four
template <class D, class Row>
HWY_INLINE FourVectors<hn::Vec<D>> load_fours(D d, const Row& row) {
#if HWY_TARGET == HWY_SCALAR  // has no vectors of four
  const auto* const only = row(0);
  return {hn::Set(d, only[0]), hn::Set(d, only[1]), hn::Set(d, only[2]), hn::Set(d, only[3])};
#else
  const hn::RepartitionToWide<D> pairs;
  const hn::FixedTag<hn::TFromD<D>, 4> four;
  const auto load = [&](std::size_t j) HWY_ATTR {
    if constexpr (hn::MaxLanes(D()) == 8) {
      return hn::Combine(d, hn::LoadU(four, row(j + 4)), hn::LoadU(four, row(j)));
    } else {
      return hn::LoadU(d, row(j));
    }
  };
  const auto r0 = load(0), r1 = load(1), r2 = load(2), r3 = load(3);
  const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));
  const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
  const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));
  const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
  return {hn::BitCast(d, hn::InterleaveLower(pairs, low01, low23)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, low01, low23)),
          hn::BitCast(d, hn::InterleaveLower(pairs, high01, high23)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, high01, high23))};
#endif
}

/// The way back.
template <class D, class V, class Row>
HWY_INLINE void store_fours([[maybe_unused]] D d, const FourVectors<V>& v, const Row& row) {
#if HWY_TARGET == HWY_SCALAR
  auto* const only = row(0);
  only[0] = hn::GetLane(v.a);
  only[1] = hn::GetLane(v.b);
  only[2] = hn::GetLane(v.c);
  only[3] = hn::GetLane(v.d);
#else
  const hn::RepartitionToWide<D> pairs;
  const hn::FixedTag<hn::TFromD<D>, 4> four;
  const auto store = [&](auto two, std::size_t j) HWY_ATTR {
    const auto rows = hn::BitCast(d, two);
    if constexpr (hn::MaxLanes(D()) == 8) {
      hn::StoreU(hn::LowerHalf(four, rows), four, row(j));
      hn::StoreU(hn::UpperHalf(four, rows), four, row(j + 4));
    } else {
      hn::StoreU(rows, d, row(j));
    }
  };
  const auto low_ab = hn::BitCast(pairs, hn::InterleaveLower(d, v.a, v.b));
  const auto low_cd = hn::BitCast(pairs, hn::InterleaveLower(d, v.c, v.d));
  const auto high_ab = hn::BitCast(pairs, hn::InterleaveUpper(d, v.a, v.b));
  const auto high_cd = hn::BitCast(pairs, hn::InterleaveUpper(d, v.c, v.d));
  store(hn::InterleaveLower(pairs, low_ab, low_cd), 0);
  store(hn::InterleaveUpper(pairs, low_ab, low_cd), 1);
  store(hn::InterleaveLower(pairs, high_ab, high_cd), 2);
  store(hn::InterleaveUpper(pairs, high_ab, high_cd), 3);
#endif
}

/// x_px, y_px, z, inv_w of a vertex in each lane.
/// @param step  from one lane's index to the next
template <class D>
HWY_INLINE FourVectors<hn::Vec<D>> load_vertices(D f, const DeviceVertex* vertices,
                                                 const std::uint32_t* index, std::size_t step) {
  return load_fours(f, [&](std::size_t lane) { return &vertices[index[lane * step]].x_px; });
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_VERTEX_LANES_INL_H_
