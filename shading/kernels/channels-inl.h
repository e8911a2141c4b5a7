// The four channels of a colour as one vector.
#if defined(KINESCOPE_SHADING_KERNELS_CHANNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_SHADING_KERNELS_CHANNELS_INL_H
#undef KINESCOPE_SHADING_KERNELS_CHANNELS_INL_H
#else
#define KINESCOPE_SHADING_KERNELS_CHANNELS_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>

#include "shading/texture.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Two texels in a row, and the two below them. Their weighted sums are kept apart until fold().
#if HWY_TARGET == HWY_SCALAR  // has no vectors of four

using Channels = std::array<float, 4>;
using Pair = Channels;

HWY_INLINE Channels channels(const Texel* t) {
  return {static_cast<float>(t->r), static_cast<float>(t->g), static_cast<float>(t->b),
          static_cast<float>(t->a)};
}
HWY_INLINE Pair weighted(const Texel* top, const Texel* bottom, float down, float left,
                         float right) {
  const Channels a = channels(top), b = channels(bottom);
  const Channels c = channels(top + 1), d = channels(bottom + 1);
  Pair sum;
  for (std::size_t i = 0; i < 4; ++i) {
    sum[i] = (a[i] + (b[i] - a[i]) * down) * left + (c[i] + (d[i] - c[i]) * down) * right;
  }
  return sum;
}
HWY_INLINE Pair add(const Pair& a, const Pair& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
HWY_INLINE Channels fold(const Pair& p) { return p; }
HWY_INLINE Channels scale(const Channels& c, float s) {
  return {c[0] * s, c[1] * s, c[2] * s, c[3] * s};
}
HWY_INLINE void write(const Channels& c, LinearRgba* out) { *out = {c[0], c[1], c[2], c[3]}; }

#else

using FourFloats = hn::FixedTag<float, 4>;
using Channels = hn::Vec<FourFloats>;

/// As many texels as D holds, as numbers up to 65535.
template <class D>
HWY_INLINE hn::Vec<D> texels(D d, const Texel* first) {
  const hn::Rebind<std::uint16_t, D> d16;
  const hn::RebindToSigned<D> di;
  return hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(d16, &first->r)));
}
template <class D>
HWY_INLINE hn::Vec<D> mixed(D d, const Texel* a, const Texel* b, float t) {
  const auto from = texels(d, a);
  return hn::MulAdd(hn::Sub(texels(d, b), from), hn::Set(d, t), from);
}
HWY_INLINE Channels channels(const Texel* texel) { return texels(FourFloats(), texel); }
HWY_INLINE Channels scale(Channels c, float s) { return hn::Mul(c, hn::Set(FourFloats(), s)); }
HWY_INLINE void write(Channels c, LinearRgba* out) { hn::StoreU(c, FourFloats(), &out->r); }

#if HWY_MAX_BYTES >= 32  // both texels of a row in one vector

using EightFloats = hn::FixedTag<float, 8>;
using Pair = hn::Vec<EightFloats>;

HWY_INLINE Pair weighted(const Texel* top, const Texel* bottom, float down, float left,
                         float right) {
  const EightFloats d;
  const FourFloats half;
  const Pair weights = hn::Combine(d, hn::Set(half, right), hn::Set(half, left));
  return hn::Mul(mixed(d, top, bottom, down), weights);
}
HWY_INLINE Channels fold(Pair p) {
  const FourFloats half;
  return hn::Add(hn::LowerHalf(half, p), hn::UpperHalf(half, p));
}

#else

using Pair = Channels;

HWY_INLINE Pair weighted(const Texel* top, const Texel* bottom, float down, float left,
                         float right) {
  const FourFloats d;
  return hn::MulAdd(mixed(d, top, bottom, down), hn::Set(d, left),
                    hn::Mul(mixed(d, top + 1, bottom + 1, down), hn::Set(d, right)));
}
HWY_INLINE Channels fold(Pair p) { return p; }

#endif
HWY_INLINE Pair add(Pair a, Pair b) { return hn::Add(a, b); }
#endif

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#endif
