#include "raster/colour/encode.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "raster/colour/srgb_table.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/colour/encode.cpp"
#include <hwy/foreach_target.h>  // compiles this file once a target
#include <hwy/highway.h>

#ifndef KINESCOPE_ENCODE_ONCE
#define KINESCOPE_ENCODE_ONCE
namespace kinescope {
namespace {

/// The curve to 16 bits as chords over the same buckets as SrgbTable; a chord is at most 0.1 code
/// off. Below kFirst the curve is a straight line.
struct ChordTable {
  static constexpr float kSlopeBelow = 12.92f * 65535;
  std::array<float, SrgbTable::kSize> value, slope;
};

const ChordTable& chord_table() {
  static const ChordTable table = [] {
    ChordTable t;
    const auto start = [](std::uint32_t i) {
      return std::bit_cast<float>(SrgbTable::kFirstBits + (i << 16));
    };
    for (std::uint32_t i = 0; i < SrgbTable::kSize; ++i) {
      const float a = start(i), b = start(i + 1);
      const float at_a = 65535 * srgb_encode(a);
      t.value[i] = at_a;
      t.slope[i] = (65535 * srgb_encode(b) - at_a) / (b - a);
    }
    return t;
  }();
  return table;
}

}  // namespace
}  // namespace kinescope
#endif

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using U = hn::ScalableTag<std::uint32_t>;
using I = hn::ScalableTag<std::int32_t>;
using Floats = hn::Vec<F>;
using Codes = hn::Vec<U>;

// Comparisons, not Max: what Max makes of NaN differs between targets.
HWY_INLINE Floats clamped(Floats x, float low) {
  const Floats least = hn::Set(F(), low);
  const Floats at_least = hn::IfThenElse(hn::Gt(x, least), x, least);
  return hn::Min(at_least, hn::Set(F(), 1.0f));
}

HWY_INLINE Codes codes8(const std::uint32_t* table, Floats x) {
  const Codes bits = hn::BitCast(U(), clamped(x, SrgbTable::kFirst));
  const Codes bucket = hn::ShiftRight<16>(hn::Sub(bits, hn::Set(U(), SrgbTable::kFirstBits)));
  const Codes entry = hn::GatherIndex(U(), table, hn::BitCast(I(), bucket));
  return hn::ShiftRight<16>(hn::Add(entry, hn::And(bits, hn::Set(U(), 0xffffu))));
}

HWY_INLINE Codes rounded(Floats x) {
  return hn::BitCast(U(), hn::ConvertTo(I(), hn::Add(x, hn::Set(F(), 0.5f))));
}

HWY_INLINE Codes codes16(const ChordTable& table, Floats x) {
  const Floats curved = clamped(x, SrgbTable::kFirst);
  const Codes bits = hn::BitCast(U(), curved);
  const Codes bucket = hn::ShiftRight<16>(hn::Sub(bits, hn::Set(U(), SrgbTable::kFirstBits)));
  const Floats start = hn::BitCast(F(), hn::And(bits, hn::Set(U(), 0xffff0000u)));
  const Floats value = hn::GatherIndex(F(), table.value.data(), hn::BitCast(I(), bucket));
  const Floats slope = hn::GatherIndex(F(), table.slope.data(), hn::BitCast(I(), bucket));
  const Floats above = hn::Add(value, hn::Mul(slope, hn::Sub(curved, start)));
  const Floats below = hn::Mul(clamped(x, 0), hn::Set(F(), ChordTable::kSlopeBelow));
  return rounded(hn::IfThenElse(hn::Gt(x, hn::Set(F(), SrgbTable::kFirst)), above, below));
}

HWY_INLINE Codes packed(Codes r, Codes g, Codes b, Codes a) {
  return hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)), hn::Or(hn::ShiftLeft<16>(b), hn::ShiftLeft<24>(a)));
}

/// Encodes whole vectors and returns how many pixels that was.
std::size_t rgba_to_8(const LinearRgba* in, std::size_t count, Srgb8* out) {
  const std::uint32_t* table = srgb_table().entries.data();
  const std::size_t step = hn::Lanes(F());
  std::size_t i = 0;
  for (; i + step <= count; i += step) {
    Floats r, g, b, a;
    hn::LoadInterleaved4(F(), &in[i].r, r, g, b, a);
    const Codes alpha = rounded(hn::Mul(clamped(a, 0), hn::Set(F(), 255.0f)));
    hn::StoreU(packed(codes8(table, r), codes8(table, g), codes8(table, b), alpha), U(),
               reinterpret_cast<std::uint32_t*>(out + i));
  }
  return i;
}

std::size_t rgb_to_8(const LinearRgb* in, std::size_t count, Srgb8* out) {
  const std::uint32_t* table = srgb_table().entries.data();
  const std::size_t step = hn::Lanes(F());
  std::size_t i = 0;
  for (; i + step <= count; i += step) {
    Floats r, g, b;
    hn::LoadInterleaved3(F(), &in[i].r, r, g, b);
    hn::StoreU(packed(codes8(table, r), codes8(table, g), codes8(table, b), hn::Set(U(), 255u)),
               U(), reinterpret_cast<std::uint32_t*>(out + i));
  }
  return i;
}

std::size_t rgb_to_16(const LinearRgb* in, std::size_t count, Srgb16* out) {
  const ChordTable& table = chord_table();
  const std::size_t step = hn::Lanes(F());
  std::size_t i = 0;
  for (; i + step <= count; i += step) {
    Floats r, g, b;
    hn::LoadInterleaved3(F(), &in[i].r, r, g, b);
    const Codes red_green = hn::Or(codes16(table, r), hn::ShiftLeft<16>(codes16(table, g)));
    const Codes blue_alpha = hn::Or(codes16(table, b), hn::Set(U(), 0xffff0000u));
    hn::StoreInterleaved2(red_green, blue_alpha, U(), reinterpret_cast<std::uint32_t*>(out + i));
  }
  return i;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(rgba_to_8);
HWY_EXPORT(rgb_to_8);
HWY_EXPORT(rgb_to_16);

void encode_row(std::span<const LinearRgba> in, std::span<Srgb8> out) {
  assert(out.size() >= in.size());
  std::size_t i = HWY_DYNAMIC_DISPATCH(rgba_to_8)(in.data(), in.size(), out.data());
  for (; i < in.size(); ++i) out[i] = encode_srgb8(in[i]);
}

void encode_row(std::span<const LinearRgb> in, std::span<Srgb8> out) {
  assert(out.size() >= in.size());
  std::size_t i = HWY_DYNAMIC_DISPATCH(rgb_to_8)(in.data(), in.size(), out.data());
  for (; i < in.size(); ++i) out[i] = encode_srgb8(in[i]);
}

void encode_row(std::span<const LinearRgb> in, std::span<Srgb16> out) {
  assert(out.size() >= in.size());
  std::size_t i = HWY_DYNAMIC_DISPATCH(rgb_to_16)(in.data(), in.size(), out.data());
  for (; i < in.size(); ++i) out[i] = encode_srgb16(in[i]);
}

}  // namespace kinescope
#endif
