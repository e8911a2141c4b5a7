#include "raster/kernels/average_samples.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/average_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 4>;  // one colour, or a channel where there are no such vectors

HWY_INLINE void add_weighted(const LinearRgba& colour, float weight, LinearRgba& sum) {
  const F f;
  for (std::size_t c = 0; c < 4; c += hn::Lanes(f)) {
    const auto part = hn::Mul(hn::LoadU(f, &colour.r + c), hn::Set(f, weight));
    hn::StoreU(hn::Add(hn::LoadU(f, &sum.r + c), part), f, &sum.r + c);
  }
}

HWY_INLINE void scale(float factor, LinearRgba& colour) {
  const F f;
  for (std::size_t c = 0; c < 4; c += hn::Lanes(f)) {
    const auto channel = hn::LoadU(f, &colour.r + c);
    hn::StoreU(hn::Mul(channel, hn::Set(f, factor)), f, &colour.r + c);
  }
}

void AverageSamples(const VisibleFragments& fragments, const LinearRgba* colours, std::size_t first,
                    std::size_t end, int samples, const LinearRgba& clear,
                    std::array<LinearRgba, TileBuffer::kBlockPixels>& out) {
  out.fill({0, 0, 0, 0});
  std::array<std::int32_t, TileBuffer::kBlockPixels> empty;
  empty.fill(samples);
  // No branch asks how many fragments a pixel has, since nobody can predict it.
  for (std::size_t i = first; i < end; ++i) {
    const std::size_t at = pixel_in_block(fragments.xy[i]);
    const std::int32_t weight = fragments.weight[i];
    empty[at] -= weight;
    add_weighted(colours[i], static_cast<float>(weight), out[at]);
  }
  const float share = 1.0f / static_cast<float>(samples);
  for (std::size_t at = 0; at < out.size(); ++at) {
    add_weighted(clear, static_cast<float>(empty[at]), out[at]);
    scale(share, out[at]);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(AverageSamples);

void average_samples(const VisibleFragments& fragments, std::span<const LinearRgba> colours,
                     std::size_t first, std::size_t end, int samples, const LinearRgba& clear,
                     std::array<LinearRgba, TileBuffer::kBlockPixels>& out) {
  HWY_DYNAMIC_DISPATCH(AverageSamples)
  (fragments, colours.data(), first, end, samples, clear, out);
}

}  // namespace kinescope
#endif
