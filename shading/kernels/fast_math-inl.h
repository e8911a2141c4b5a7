// Logarithm, power and inverse square root of vectors, as exact as colours need.
#if defined(KINESCOPE_SHADING_KERNELS_FAST_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_SHADING_KERNELS_FAST_MATH_INL_H
#undef KINESCOPE_SHADING_KERNELS_FAST_MATH_INL_H
#else
#define KINESCOPE_SHADING_KERNELS_FAST_MATH_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// log2 of positive normal numbers, by a minimax polynomial on [sqrt(1/2), sqrt(2)).
/// Relative error below 8e-6, near 1 too; +infinity gives 128, and 0 about -127.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V fast_log2(D d, V x) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  // Bits of sqrt(1/2): the difference holds the exponent that leaves the mantissa in the range.
  const auto bits = hn::BitCast(du, x);
  const auto offset = hn::Sub(bits, hn::Set(du, 0x3F3504F3u));
  const auto exponent = hn::ShiftRight<23>(hn::BitCast(di, offset));
  const auto scale = hn::BitCast(du, hn::ShiftLeft<23>(exponent));
  const V f = hn::Sub(hn::BitCast(d, hn::Sub(bits, scale)), hn::Set(d, 1.0f));
  V p = hn::Set(d, -0.20619108f);
  p = hn::MulAdd(p, f, hn::Set(d, 0.318199916f));
  p = hn::MulAdd(p, f, hn::Set(d, -0.366491702f));
  p = hn::MulAdd(p, f, hn::Set(d, 0.479811855f));
  p = hn::MulAdd(p, f, hn::Set(d, -0.72120639f));
  p = hn::MulAdd(p, f, hn::Set(d, 1.44270162f));
  return hn::MulAdd(p, f, hn::ConvertTo(d, exponent));
}

/// 2^x for x in [-126, 126], by a minimax polynomial on [-1/2, 1/2]. Relative error below 3e-6.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V fast_exp2(D d, V x) {
  const hn::RebindToUnsigned<D> du;
  // Adding 1.5 2^23 rounds to a whole number and leaves it in the last binary places.
  const V shifter = hn::Set(d, 12582912.0f);
  const V shifted = hn::Add(x, shifter);
  const V f = hn::Sub(x, hn::Sub(shifted, shifter));
  V p = hn::Set(d, 0.00957010201f);
  p = hn::MulAdd(p, f, hn::Set(d, 0.0559178603f));
  p = hn::MulAdd(p, f, hn::Set(d, 0.240247448f));
  p = hn::MulAdd(p, f, hn::Set(d, 0.693121815f));
  p = hn::MulAdd(p, f, hn::Set(d, 0.999999261f));
  const auto scale = hn::ShiftLeft<23>(hn::BitCast(du, shifted));
  return hn::BitCast(d, hn::Add(hn::BitCast(du, p), scale));
}

/// x^n for x in (0, 1] and n >= 0, where x^n is at least 2^-100. Absolute error below 1e-5, plus
/// what the rounding of x costs by itself (n 6e-8 x^n).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V fast_pow(D d, V x, V n) {
  return fast_exp2(d, hn::Mul(n, fast_log2(d, x)));
}

/// 1 / sqrt(x) for positive normal x: the processor's estimate and one step of Newton's method.
/// Relative error below 1e-6.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V fast_rsqrt(D d, V x) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128  // whose estimates are coarse
  return hn::Div(hn::Set(d, 1.0f), hn::Sqrt(x));
#else
  const V y = hn::ApproximateReciprocalSqrt(x);
  const V half_y = hn::Mul(y, hn::Set(d, 0.5f));
  return hn::Mul(half_y, hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, 3.0f)));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#endif
