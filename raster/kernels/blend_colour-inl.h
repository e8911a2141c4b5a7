// The law of blending in vectors, and colours that are held while fragments are laid over them.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_BLEND_COLOUR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_BLEND_COLOUR_INL_H_
#undef KINESCOPE_RASTER_KERNELS_BLEND_COLOUR_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_BLEND_COLOUR_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "raster/blending.h"
#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR  // has no vectors of four
/// The colour of a sample while fragments are blended onto it.
class Below {
 public:
  explicit HWY_INLINE Below(const LinearRgba& colour) : colour_(colour) {}
  template <BlendMode kMode>
  HWY_INLINE void lay(const LinearRgba& source) {
    colour_ = blended(kMode, source, colour_);
  }
  HWY_INLINE void store(LinearRgba& to) const { to = colour_; }

 private:
  LinearRgba colour_;
};
#else
using One = hn::FixedTag<float, 4>;   // a colour
using Two = hn::CappedTag<float, 8>;  // two, or one where vectors are of four

alignas(16) constexpr std::array<float, 4> kLeast = {-kMostLight, -kMostLight, -kMostLight, 0};
alignas(16) constexpr std::array<float, 4> kMost = {kMostLight, kMostLight, kMostLight, 1};
alignas(16) constexpr std::array<float, 4> kAlphaLane = {0, 0, 0, 1};

/// blended(), of as many colours as a vector holds.
template <BlendMode kMode, class D>
HWY_INLINE hn::Vec<D> blend(D d, hn::Vec<D> source, hn::Vec<D> below) {
  if constexpr (kMode == BlendMode::kOpaque) {
    return source;
  } else {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const auto number = hn::IfThenElseZero(hn::Eq(source, source), source);
    const auto cut =
        hn::Min(hn::Max(number, hn::LoadDup128(d, kLeast.data())), hn::LoadDup128(d, kMost.data()));
    const auto alpha = hn::Broadcast<3>(cut);
    const auto alpha_lane = hn::Ne(hn::LoadDup128(d, kAlphaLane.data()), zero);
    if constexpr (kMode == BlendMode::kAlpha) {
      const auto s = hn::IfThenElse(alpha_lane, one, cut);
      return hn::Add(hn::Mul(s, alpha), hn::Mul(below, hn::Sub(one, alpha)));
    } else if constexpr (kMode == BlendMode::kAdditive) {
      const auto s = hn::IfThenZeroElse(alpha_lane, cut);
      return hn::Add(below, hn::Mul(s, alpha));
    } else {
      const auto s = hn::IfThenElse(alpha_lane, one, cut);
      return hn::Mul(below, hn::Sub(one, hn::Mul(alpha, hn::Sub(one, s))));
    }
  }
}

/// The colour of a sample while fragments are blended onto it.
class Below {
 public:
  explicit HWY_INLINE Below(const LinearRgba& colour) : colour_(hn::LoadU(One(), &colour.r)) {}
  template <BlendMode kMode>
  HWY_INLINE void lay(const LinearRgba& source) {
    const One one;
    colour_ = blend<kMode>(one, hn::LoadU(one, &source.r), colour_);
  }
  HWY_INLINE void store(LinearRgba& to) const { hn::StoreU(colour_, One(), &to.r); }

 private:
  hn::Vec<One> colour_;
};

template <BlendMode kMode>
HWY_INLINE void blend_two(hn::Vec<Two> source, LinearRgba* to) {
  const Two two;
  hn::StoreU(blend<kMode>(two, source, hn::LoadU(two, &to->r)), two, &to->r);
}
#endif

template <BlendMode kMode>
HWY_INLINE void blend_one(const LinearRgba& source, LinearRgba& to) {
  Below below(to);
  below.lay<kMode>(source);
  below.store(to);
}

#if HWY_TARGET != HWY_SCALAR
/// All samples of a pixel while fragments are blended onto them.
template <std::size_t kSamples>
class AllBelow {
 public:
  explicit HWY_INLINE AllBelow(const LinearRgba* samples) {
    for (std::size_t v = 0; v < kVectors; ++v) {
      colours_[v] = hn::LoadU(Two(), &samples[v * kColours].r);
    }
  }
  /// @param bits  the samples that are covered
  template <BlendMode kMode>
  HWY_INLINE void lay(const LinearRgba& colour, std::uint32_t bits) {
    const Two two;
    const auto source = hn::LoadDup128(two, &colour.r);
    const bool all = bits == (1u << kSamples) - 1;
    for (std::size_t v = 0; v < kVectors; ++v, bits >>= kColours) {
      const auto mixed = blend<kMode>(two, source, colours_[v]);
      colours_[v] = all ? mixed : hn::IfThenElse(covered(bits), mixed, colours_[v]);
    }
  }
  HWY_INLINE void store(LinearRgba* samples) const {
    for (std::size_t v = 0; v < kVectors; ++v) {
      hn::StoreU(colours_[v], Two(), &samples[v * kColours].r);
    }
  }

 private:
  static constexpr std::size_t kColours = hn::MaxLanes(Two()) / 4, kVectors = kSamples / kColours;
  /// The lanes of the samples in the lowest bits.
  static HWY_INLINE hn::Mask<Two> covered(std::uint32_t bits) {
    const hn::RebindToUnsigned<Two> u;
    const auto bit = hn::Add(hn::ShiftRight<2>(lane_numbers(u)), hn::Set(u, 1));  // 1 or 2
    return hn::RebindMask(Two(), hn::TestBit(hn::Set(u, bits), bit));
  }
  hn::Vec<Two> colours_[kVectors];
};
#endif

/// Calls the body with a constant of the mode.
template <typename Body>
HWY_INLINE void with_mode(BlendMode mode, const Body& body) {
  switch (mode) {
    case BlendMode::kOpaque:
      return body(std::integral_constant<BlendMode, BlendMode::kOpaque>());
    case BlendMode::kAlpha:
      return body(std::integral_constant<BlendMode, BlendMode::kAlpha>());
    case BlendMode::kAdditive:
      return body(std::integral_constant<BlendMode, BlendMode::kAdditive>());
    case BlendMode::kMultiply:
      return body(std::integral_constant<BlendMode, BlendMode::kMultiply>());
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_BLEND_COLOUR_INL_H_
