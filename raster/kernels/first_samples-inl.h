// What the first samples of pixels show. Included once for each instruction set, hence the unusual
// guard.
#if defined(KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

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
    HWY_ALIGN std::array<std::uint32_t, 8> first;
    HWY_ALIGN std::array<std::uint32_t, 8> differ;
    for (std::size_t k = 0; k < hn::Lanes(u); ++k, ids += kSamples) {
      first[k] = ids[0];
      differ[k] = 0;
      for (int s = 1; s < kSamples; ++s) differ[k] |= ids[s] ^ ids[0];
    }
    agree = hn::AllFalse(u, hn::And(within, hn::Ne(hn::Load(u, differ.data()), hn::Zero(u))));
    return hn::Load(u, first.data());
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_FIRST_SAMPLES_INL_H_
