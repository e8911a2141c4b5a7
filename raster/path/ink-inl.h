// Lays ink on several pixels at a time, exactly as ink.h does on one.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_PATH_INK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_PATH_INK_INL_H_
#undef KINESCOPE_RASTER_PATH_INK_INL_H_
#else
#define KINESCOPE_RASTER_PATH_INK_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "raster/path/ink.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using CoverTag = hn::CappedTag<float, 8>;
using CoverHalfTag = hn::CappedTag<float, 4>;
using Cover = hn::Vec<CoverTag>;
inline constexpr int kCoverLanes = static_cast<int>(hn::MaxLanes(CoverTag()));

template <class Pixel>
class InkLanes;

template <class Pixel>
HWY_INLINE void lay_part(const InkLanes<Pixel>& ink, Cover coverage, Pixel* pixels, int count);

#if HWY_TARGET == HWY_SCALAR
template <>
class InkLanes<Linear8> {
 public:
  explicit InkLanes(const Ink& ink) : codes_(ink) {}

  void lay(Cover coverage, Linear8* pixels) const {
    ink::lay(codes_, hn::GetLane(coverage), *pixels);
  }
  void lay_evenly(Cover coverage, Linear8* pixels, int count) const {
    for (int i = 0; i < count; ++i) lay(coverage, pixels + i);
  }

 private:
  ink::Codes codes_;
};
#else
/// The channels of a pixel are taken in pairs, 16 bits each, so that one share serves two of them
/// and none is moved.
template <>
class InkLanes<Linear8> {
 public:
  HWY_INLINE explicit InkLanes(const Ink& ink) {
    const ink::Codes codes(ink);
    even_ = pair(codes.r, codes.b);
    odd_ = pair(codes.g, codes.a);
    alpha_ = codes.alpha;
    taken_ = codes.mixing == Mixing::kOver ? ~0u : 0;
  }

  /// Lays it on consecutive pixels, one a lane.
  HWY_INLINE void lay(Cover coverage, Linear8* pixels) const {
    const hn::RebindToUnsigned<CoverTag> u;
    auto* words = reinterpret_cast<std::uint32_t*>(pixels);
    hn::StoreU(mixed(coverage, hn::LoadU(u, words)), u, words);
  }

  /// The same coverage on any number of pixels.
  HWY_INLINE void lay_evenly(Cover coverage, Linear8* pixels, int count) const {
    const U u;
    auto* words = reinterpret_cast<std::uint32_t*>(pixels);
    if (taken_ != 0 && alpha_ == ink::Codes::kOne && hn::GetLane(coverage) == 1) {
      std::fill_n(words, count, even_ | odd_ << 8);
      return;
    }
    int i = 0;
    for (; i + kCoverLanes <= count; i += kCoverLanes) {
      hn::StoreU(mixed(coverage, hn::LoadU(u, words + i)), u, words + i);
    }
    if (i < count) lay_part(*this, coverage, pixels + i, count - i);
  }

  /// The lower half of the lanes on consecutive pixels, the upper half on others.
  HWY_INLINE void lay(Cover coverage, Linear8* lower, Linear8* upper) const {
    const hn::RebindToUnsigned<CoverTag> u;
    const hn::Half<decltype(u)> half;
    auto* low = reinterpret_cast<std::uint32_t*>(lower);
    auto* high = reinterpret_cast<std::uint32_t*>(upper);
    const auto sum = mixed(coverage, hn::Combine(u, hn::LoadU(half, high), hn::LoadU(half, low)));
    hn::StoreU(hn::LowerHalf(half, sum), half, low);
    hn::StoreU(hn::UpperHalf(half, sum), half, high);
  }

 private:
  using U = hn::RebindToUnsigned<CoverTag>;
  using U16 = hn::Repartition<std::uint16_t, U>;
  using I16 = hn::Repartition<std::int16_t, U>;

  static std::uint32_t pair(std::int32_t low, std::int32_t high) {
    return static_cast<std::uint32_t>(low | high << 16);
  }

  HWY_INLINE hn::Vec<U> mixed(Cover coverage, hn::Vec<U> under) const {
    const CoverTag f;
    const U u;
    const U16 u16;
    const I16 i16;
    const auto rounded =
        hn::Add(hn::Mul(coverage, hn::Set(f, alpha_)), hn::Set(f, ink::Codes::kRound));
    const auto bits = hn::BitCast(u, rounded);
    const auto share =
        hn::BitCast(i16, hn::Or(hn::And(bits, hn::Set(u, 0xffffu)), hn::ShiftLeft<16>(bits)));
    const auto even = hn::BitCast(i16, hn::And(under, hn::Set(u, 0x00ff00ffu)));
    const auto odd = hn::BitCast(i16, hn::ShiftRight<8>(hn::BitCast(u16, under)));
    const auto ink_even = hn::BitCast(i16, hn::Set(u, even_));
    const auto ink_odd = hn::BitCast(i16, hn::Set(u, odd_));
    const auto top = hn::Set(i16, std::int16_t{255});
    const auto taken = hn::BitCast(i16, hn::Set(u, taken_));
    const auto sum = [&](auto below, auto ink) {
      const auto change = hn::Sub(ink, hn::And(below, taken));
      return hn::Min(hn::Add(below, hn::MulFixedPoint15(change, share)), top);
    };
    const auto high = hn::ShiftLeft<8>(hn::BitCast(u16, sum(odd, ink_odd)));
    return hn::Or(hn::BitCast(u, sum(even, ink_even)), hn::BitCast(u, high));
  }

  std::uint32_t even_, odd_;
  std::uint32_t taken_;  ///< all bits if the ink takes the place of what is below
  float alpha_;
};
#endif

template <>
class InkLanes<LinearRgba> {
 public:
  HWY_INLINE explicit InkLanes(const Ink& ink) : light_(ink) {}

  HWY_INLINE void lay(Cover coverage, LinearRgba* pixels) const {
    alignas(32) std::array<float, kCoverLanes> shares;
    hn::Store(hn::Mul(coverage, hn::Set(CoverTag(), light_.alpha)), CoverTag(), shares.data());
    lay_pixels(shares.data(), kCoverLanes, pixels);
  }

  HWY_INLINE void lay_evenly(Cover coverage, LinearRgba* pixels, int count) const {
    const float share = hn::GetLane(coverage) * light_.alpha;
    for (int i = 0; i < count; ++i) lay_pixels(&share, 1, pixels + i);
  }

#if HWY_TARGET != HWY_SCALAR
  HWY_INLINE void lay(Cover coverage, LinearRgba* lower, LinearRgba* upper) const {
    alignas(32) std::array<float, kCoverLanes> shares;
    hn::Store(hn::Mul(coverage, hn::Set(CoverTag(), light_.alpha)), CoverTag(), shares.data());
    lay_pixels(shares.data(), kCoverLanes / 2, lower);
    lay_pixels(shares.data() + kCoverLanes / 2, kCoverLanes / 2, upper);
  }
#endif

 private:
  HWY_INLINE void lay_pixels(const float* shares, int count, LinearRgba* pixels) const {
    const CoverHalfTag f;
    const bool over = light_.mixing == Mixing::kOver;
    for (int i = 0; i < count; ++i) {
      if (shares[i] == 0) continue;
      if (shares[i] == 1 && over) {
        pixels[i] = light_.colour;
        continue;
      }
      for (std::size_t c = 0; c < 4; c += hn::Lanes(f)) {
        float* channels = &pixels[i].r + c;
        const auto under = hn::LoadU(f, channels);
        const auto light = hn::LoadU(f, &light_.colour.r + c);
        const auto change = over ? hn::Sub(light, under) : light;
        hn::StoreU(hn::Add(under, hn::Mul(change, hn::Set(f, shares[i]))), f, channels);
      }
    }
  }

  ink::Light light_;
};

/// The first `count` lanes only: no pixel beyond is read.
template <class Pixel>
HWY_INLINE void lay_part(const InkLanes<Pixel>& ink, Cover coverage, Pixel* pixels, int count) {
  std::array<Pixel, kCoverLanes> copy{};
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(Pixel);
  std::memcpy(copy.data(), pixels, bytes);
  ink.lay(coverage, copy.data());
  std::memcpy(pixels, copy.data(), bytes);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // include guard
