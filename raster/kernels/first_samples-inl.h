// What the first samples of pixels show. Included once for each instruction set, hence the unusual
// guard.
#if defined(KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "raster/kernels/vertex_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The first sample's triangles of several pixels, and whether all samples of each agree.
template <int kSamples, class U>
HWY_INLINE hn::Vec<U> first_samples(U u, const std::uint32_t* ids, hn::Mask<U> within,
                                    bool& agree) {
  if constexpr (kSamples == 1) {
    agree = true;
    return hn::Load(u, ids);
  } else if constexpr (kSamples == 4) {
    hn::Vec<U> a, b, c, d;
    hn::LoadInterleaved4(u, ids, a, b, c, d);
    const auto differ = hn::Or(hn::Or(hn::Xor(a, b), hn::Xor(a, c)), hn::Xor(a, d));
    agree = hn::AllFalse(u, hn::And(within, hn::Ne(differ, hn::Zero(u))));
    return a;
  } else {
    static_assert(kSamples == 8);
    auto differ = hn::Zero(u);
    for (std::size_t k = 0; k < hn::CountTrue(u, within); ++k) {
      const auto first = hn::Set(u, ids[k * kSamples]);
      HWY_UNROLL(8)
      for (std::size_t s = 0; s < kSamples; s += hn::MaxLanes(U())) {
        differ = hn::Or(differ, hn::Xor(first, hn::Load(u, ids + k * kSamples + s)));
      }
    }
    agree = hn::AllTrue(u, hn::Eq(differ, hn::Zero(u)));
    return load_fours(u, [&](std::size_t k) { return ids + k * kSamples; }).a;
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
