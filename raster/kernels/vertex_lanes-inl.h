// Rows of four floats, one a lane, turned into four vectors: vertices lie that way in memory.
// Included once for each instruction set, hence the unusual guard.
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

/// Loads four floats for each lane, at most eight of them, and transposes.
/// @param row  the address of a lane's four
template <class D, class Row>
HWY_INLINE FourVectors<hn::Vec<D>> load_fours(D f, const Row& row) {
#if HWY_TARGET == HWY_SCALAR  // has no vectors of four
  const float* const only = row(0);
  return {hn::Set(f, only[0]), hn::Set(f, only[1]), hn::Set(f, only[2]), hn::Set(f, only[3])};
#else
  const hn::RepartitionToWide<D> pairs;
  const hn::FixedTag<float, 4> four;
  const auto load = [&](std::size_t j) HWY_ATTR {
    if constexpr (hn::MaxLanes(D()) == 8) {
      return hn::Combine(f, hn::LoadU(four, row(j + 4)), hn::LoadU(four, row(j)));
    } else {
      return hn::LoadU(f, row(j));
    }
  };
  const auto r0 = load(0), r1 = load(1), r2 = load(2), r3 = load(3);
  const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(f, r0, r1));
  const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(f, r2, r3));
  const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(f, r0, r1));
  const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(f, r2, r3));
  return {hn::BitCast(f, hn::InterleaveLower(pairs, low01, low23)),
          hn::BitCast(f, hn::InterleaveUpper(pairs, low01, low23)),
          hn::BitCast(f, hn::InterleaveLower(pairs, high01, high23)),
          hn::BitCast(f, hn::InterleaveUpper(pairs, high01, high23))};
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
