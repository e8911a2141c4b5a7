#include "raster/kernels/linear8.h"

#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/linear8.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F>
HWY_INLINE void quantize(F f, const float* in, std::uint8_t* out) {
  const hn::Rebind<std::int32_t, F> i;
  const hn::Rebind<std::uint8_t, F> u8;
  const auto zero = hn::Zero(f);
  const auto v = hn::LoadU(f, in);
  const auto number = hn::IfThenElseZero(hn::Eq(v, v), v);  // NaN is no number
  const auto clamped = hn::Min(hn::Max(number, zero), hn::Set(f, 1.0f));
  const auto scaled = hn::Add(hn::Mul(clamped, hn::Set(f, 255.0f)), hn::Set(f, 0.5f));
  hn::StoreU(hn::DemoteTo(u8, hn::ConvertTo(i, scaled)), u8, out);
}

void QuantizeRow(const float* in, std::uint8_t* out, std::size_t channels) {
  const hn::CappedTag<float, 16> f;
  const hn::CappedTag<float, 1> one;
  std::size_t k = 0;
  for (; k + hn::Lanes(f) <= channels; k += hn::Lanes(f)) quantize(f, in + k, out + k);
  for (; k < channels; ++k) quantize(one, in + k, out + k);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(QuantizeRow);

void quantize_row(std::span<const LinearRgba> in, std::span<Linear8> out) {
  static_assert(sizeof(LinearRgba) == 4 * sizeof(float) && sizeof(Linear8) == 4);
  HWY_DYNAMIC_DISPATCH(QuantizeRow)(&in.data()->r, &out.data()->r, 4 * in.size());
}

}  // namespace kinescope
#endif
