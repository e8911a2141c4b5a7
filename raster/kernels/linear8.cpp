#include "raster/kernels/linear8.h"

#include <array>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/linear8.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Channels as whole numbers from 0 to 255: the nearest, of two the even one.
template <class F>
HWY_INLINE auto codes(F f, const float* in) {
  const hn::Rebind<std::int32_t, F> i;
  const auto v = hn::LoadU(f, in);
  // Of NaN, which is no number, the comparison makes 0.
  const auto clamped = hn::Min(hn::IfThenElseZero(hn::Gt(v, hn::Zero(f)), v), hn::Set(f, 1.0f));
  // Added to 2^23, a number is rounded to a whole one, which the last bits then hold.
  const auto shifter = hn::Set(f, 8388608.0f);
  const auto rounded = hn::Add(hn::Mul(clamped, hn::Set(f, 255.0f)), shifter);
  return hn::And(hn::BitCast(i, rounded), hn::Set(i, 255));
}

#if HWY_TARGET != HWY_SCALAR  // has no vectors of four
/// Four vectors of channels become one of bytes.
class FourToOne {
 public:
  using F = hn::CappedTag<float, 8>;

  FourToOne() {
    // Bytes of a 128-bit block, whose 16-bit lanes hold channels of pixels a, then b in their low
    // halves, of c, then d in their high ones; then whole pixels, block by block.
    HWY_ALIGN static constexpr std::uint8_t kBytes[16] = {0, 2, 4, 6, 8, 10, 12, 14,
                                                          1, 3, 5, 7, 9, 11, 13, 15};
    HWY_ALIGN static constexpr auto kPixels = [] {
      std::array<std::int32_t, kLanes> lanes{};
      for (int p = 0; p < kLanes; ++p) {
        lanes[static_cast<std::size_t>(p)] = p % kBlocks * 4 + p / kBlocks;
      }
      return lanes;
    }();
    bytes_ = hn::LoadDup128(u8, kBytes);
    pixels_ = hn::IndicesFromVec(i32, hn::Load(i32, kPixels.data()));
  }

  HWY_INLINE void operator()(const float* in, std::uint8_t* out) const {
    const auto at = [&](int v) HWY_ATTR { return codes(F(), in + v * kLanes); };
    const auto low = hn::ReorderDemote2To(i16, at(0), at(1));
    const auto high = hn::ReorderDemote2To(i16, at(2), at(3));
    const auto mixed = hn::BitCast(u8, hn::Or(low, hn::ShiftLeft<8>(high)));
    const auto blocks = hn::BitCast(i32, hn::TableLookupBytes(mixed, bytes_));
    hn::StoreU(hn::BitCast(u8, hn::TableLookupLanes(blocks, pixels_)), u8, out);
  }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(F())), kBlocks = kLanes / 4;
  static constexpr hn::RebindToSigned<F> i32{};
  static constexpr hn::Repartition<std::int16_t, F> i16{};
  static constexpr hn::Repartition<std::uint8_t, F> u8{};
  hn::Vec<hn::Repartition<std::uint8_t, F>> bytes_;
  decltype(hn::IndicesFromVec(i32, hn::Zero(i32))) pixels_;
};
#endif

void QuantizeRow(const float* in, std::uint8_t* out, std::size_t channels) {
  std::size_t k = 0;
#if HWY_TARGET != HWY_SCALAR
  const FourToOne quantize;
  const std::size_t step = 4 * hn::Lanes(FourToOne::F());
  for (; k + step <= channels; k += step) quantize(in + k, out + k);
#endif
  const hn::CappedTag<float, 1> one;
  const hn::Rebind<std::uint8_t, decltype(one)> byte;
  for (; k < channels; ++k) hn::StoreU(hn::DemoteTo(byte, codes(one, in + k)), byte, out + k);
}

void QuantizeBlock(const float* in, std::uint8_t* out, std::size_t row_bytes) {
  constexpr std::size_t kRow = 32;  // channels
#if HWY_TARGET != HWY_SCALAR
  const FourToOne quantize;
  constexpr std::size_t kStep = 4 * hn::MaxLanes(FourToOne::F());
  if constexpr (kStep <= kRow) {
    for (std::size_t r = 0; r < 8; ++r, in += kRow, out += row_bytes) {
      for (std::size_t k = 0; k < kRow; k += kStep) quantize(in + k, out + k);
    }
    return;
  }
#endif
  for (std::size_t r = 0; r < 8; ++r) QuantizeRow(in + r * kRow, out + r * row_bytes, kRow);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(QuantizeRow);
HWY_EXPORT(QuantizeBlock);

void quantize_row(std::span<const LinearRgba> in, std::span<Linear8> out) {
  static_assert(sizeof(LinearRgba) == 4 * sizeof(float) && sizeof(Linear8) == 4);
  HWY_DYNAMIC_DISPATCH(QuantizeRow)(&in.data()->r, &out.data()->r, 4 * in.size());
}

void quantize_block(std::span<const LinearRgba, 64> in, Linear8* out, std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(QuantizeBlock)(&in.data()->r, &out->r, stride * sizeof(Linear8));
}

}  // namespace kinescope
#endif
