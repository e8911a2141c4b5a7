// The numbers of a vector's lanes. Highway 1.0.3's Iota and FirstN count them in a loop at each
// use. Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_LANES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_LANES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// 0, 1, 2, ...
template <class D>
HWY_INLINE hn::Vec<D> lane_numbers(D d) {
  using T = hn::TFromD<D>;
  alignas(64) static constexpr auto kNumbers = [] {
    std::array<T, hn::MaxLanes(D())> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<T>(k);
    return numbers;
  }();
  return hn::Load(d, kNumbers.data());
}

/// first, first + 1, ...
template <class D>
HWY_INLINE hn::Vec<D> lanes_from(D d, hn::TFromD<D> first) {
  return hn::Add(lane_numbers(d), hn::Set(d, first));
}

/// The first `count` lanes, of which there may be fewer.
template <class D>
HWY_INLINE hn::Mask<D> first_lanes(D d, std::size_t count) {
  const hn::RebindToSigned<D> i;
  using T = hn::TFromD<decltype(i)>;
  return hn::RebindMask(d, hn::Lt(lane_numbers(i), hn::Set(i, static_cast<T>(count))));
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_LANES_INL_H_
