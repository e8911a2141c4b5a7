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

/// The clear colour for the samples that no fragment covers.
HWY_INLINE void add_clear(const VisibleFragments& fragments, std::size_t first, std::size_t end,
                          int samples, float share, const LinearRgba& clear,
                          std::array<LinearRgba, TileBuffer::kBlockPixels>& out) {
  std::array<std::int32_t, TileBuffer::kBlockPixels> empty;
  empty.fill(samples);
  for (std::size_t i = first; i < end; ++i) {
    empty[pixel_in_block(fragments.xy[i])] -= fragments.weight[i];
  }
  for (std::size_t at = 0; at < out.size(); ++at) {
    add_weighted(clear, static_cast<float>(empty[at]) * share, out[at]);
  }
}

void AverageSamples(const VisibleFragments& fragments, const LinearRgba* colours, std::size_t first,
                    std::size_t end, int samples, const LinearRgba& clear,
                    std::array<LinearRgba, TileBuffer::kBlockPixels>& out) {
  // A power of two: to multiply by it first or last is the same.
  const float share = 1.0f / static_cast<float>(samples);
  std::array<float, 9> weighted;
  for (std::size_t w = 0; w < weighted.size(); ++w) weighted[w] = static_cast<float>(w) * share;
  out.fill({0, 0, 0, 0});
  std::uint32_t covered = 0;
  // No branch asks how many fragments a pixel has, since nobody can predict it.
  for (std::size_t i = first; i < end; ++i) {
    const std::uint32_t weight = fragments.weight[i];
    covered += weight;
    add_weighted(colours[i], weighted[weight], out[pixel_in_block(fragments.xy[i])]);
  }
  if (covered != TileBuffer::kBlockPixels * static_cast<std::uint32_t>(samples)) {
    add_clear(fragments, first, end, samples, share, clear, out);
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
