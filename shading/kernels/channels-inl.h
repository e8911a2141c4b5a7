// The four channels of a colour as one vector, still scaled by 65535 as in texels.
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

#if HWY_TARGET == HWY_SCALAR  // has no vectors of four

using Channels = std::array<float, 4>;

HWY_INLINE Channels channels(const Texel* t) {
  return {static_cast<float>(t->r), static_cast<float>(t->g), static_cast<float>(t->b),
          static_cast<float>(t->a)};
}
HWY_INLINE Channels mix(const Channels& a, const Channels& b, float t) {
  Channels mixed;
  for (std::size_t i = 0; i < 4; ++i) mixed[i] = a[i] + (b[i] - a[i]) * t;
  return mixed;
}
HWY_INLINE void write(const Channels& c, LinearRgba* out) {
  constexpr float kScale = 1.0f / 65535.0f;
  *out = {c[0] * kScale, c[1] * kScale, c[2] * kScale, c[3] * kScale};
}

#else

using FourFloats = hn::FixedTag<float, 4>;
using Channels = hn::Vec<FourFloats>;

HWY_INLINE Channels channels(const Texel* texel) {
  const hn::Rebind<std::uint16_t, FourFloats> d16;
  const hn::RebindToSigned<FourFloats> di;
  return hn::ConvertTo(FourFloats(), hn::PromoteTo(di, hn::LoadU(d16, &texel->r)));
}
HWY_INLINE Channels mix(Channels a, Channels b, float t) {
  return hn::MulAdd(hn::Sub(b, a), hn::Set(FourFloats(), t), a);
}
HWY_INLINE void write(Channels c, LinearRgba* out) {
  const FourFloats d;
  hn::StoreU(hn::Mul(c, hn::Set(d, 1.0f / 65535.0f)), d, &out->r);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#endif
