// Vectors of up to eight floats, which the display's loops over columns are written in. Included
// once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_DISPLAY_EIGHT_FLOATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_DISPLAY_EIGHT_FLOATS_INL_H_
#undef KINESCOPE_DISPLAY_EIGHT_FLOATS_INL_H_
#else
#define KINESCOPE_DISPLAY_EIGHT_FLOATS_INL_H_
#endif

#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"  // before `d` is a name here

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kMostLanes = 8;
using F = hn::CappedTag<float, kMostLanes>;
using I = hn::RebindToSigned<F>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;
constexpr F d;
constexpr I di;

HWY_INLINE int lanes() { return static_cast<int>(hn::Lanes(d)); }
HWY_INLINE Floats set(float v) { return hn::Set(d, v); }

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
