#include "display/tube/spread_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube/spread_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using F = hn::CappedTag<float, kGroup>;
using I = hn::RebindToSigned<F>;
using Floats = hn::Vec<F>;
constexpr F d;
constexpr I di;

HWY_INLINE int lanes() { return static_cast<int>(hn::Lanes(d)); }
HWY_INLINE Floats set(float v) { return hn::Set(d, v); }

/// 2^x for x <= 0, to 3e-6; 0 far below.
HWY_INLINE Floats exp2_below(Floats x) {
  x = hn::Max(x, set(-126.0f));
  const Floats whole = hn::Round(x);
  const Floats f = hn::Sub(x, whole);
  Floats p = hn::MulAdd(set(0.00956051f), f, set(0.05591712f));
  p = hn::MulAdd(p, f, set(0.24024981f));
  p = hn::MulAdd(p, f, set(0.69312196f));
  p = hn::MulAdd(p, f, set(0.99999919f));
  const auto exponent = hn::ShiftLeft<23>(hn::ConvertTo(di, whole));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, p), exponent));
}

/// A normal distribution's share below z deviations, less a half; cut at 3 and scaled to reach it.
HWY_INLINE Floats normal_below(Floats z) {
  z = hn::Min(hn::Max(z, set(-3.0f)), set(3.0f));
  const Floats q = hn::Mul(z, z);
  Floats p = hn::MulAdd(set(-1.4823849e-06f), q, set(5.5700488e-05f));
  p = hn::MulAdd(p, q, set(-0.00093099633f));
  p = hn::MulAdd(p, q, set(0.0094104743f));
  p = hn::MulAdd(p, q, set(-0.066073838f));
  p = hn::MulAdd(p, q, set(0.39984757f));
  return hn::Mul(p, z);
}

struct Pair {
  Floats narrow, wide;
};

/// kTaps known lets the compiler unroll; 0 takes any number.
template <int kTaps>
HWY_INLINE void AcrossPermuted(const AcrossTable& table, CellRows cells, SpreadRows out) {
  const int taps = kTaps > 0 ? kTaps : table.taps;
  for (int x = 0; x < table.groups * kGroup; x += lanes()) {
    const int base = table.start[x];
    const auto lane =
        hn::IndicesFromVec(d, hn::Sub(hn::LoadU(di, table.start + x), hn::Set(di, base)));
    Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 6
    for (int t = 0; t < taps; ++t) {
      const Floats n = hn::TableLookupLanes(hn::LoadU(d, cells.narrow + base + t), lane);
      const Floats w = hn::TableLookupLanes(hn::LoadU(d, cells.wide + base + t), lane);
      sum.narrow = hn::MulAdd(n, hn::LoadU(d, table.narrow + t * table.pitch + x), sum.narrow);
      sum.wide = hn::MulAdd(w, hn::LoadU(d, table.wide + t * table.pitch + x), sum.wide);
    }
    hn::StoreU(sum.narrow, d, out.narrow + x);
    hn::StoreU(sum.wide, d, out.wide + x);
  }
}

HWY_INLINE void AcrossGathered(const AcrossTable& table, CellRows cells, SpreadRows out) {
  for (int x = 0; x < table.groups * kGroup; x += lanes()) {
    auto at = hn::LoadU(di, table.start + x);
    Pair sum{hn::Zero(d), hn::Zero(d)};
    for (int t = 0; t < table.taps; ++t, at = hn::Add(at, hn::Set(di, 1))) {
      const Floats n = hn::GatherIndex(d, cells.narrow, at);
      const Floats w = hn::GatherIndex(d, cells.wide, at);
      sum.narrow = hn::MulAdd(n, hn::LoadU(d, table.narrow + t * table.pitch + x), sum.narrow);
      sum.wide = hn::MulAdd(w, hn::LoadU(d, table.wide + t * table.pitch + x), sum.wide);
    }
    hn::StoreU(sum.narrow, d, out.narrow + x);
    hn::StoreU(sum.wide, d, out.wide + x);
  }
}

void SpreadAcross(const AcrossTable& table, CellRows cells, SpreadRows out) {
  if (!table.close) return AcrossGathered(table, cells, out);
  switch (table.taps) {
    case 4:
      return AcrossPermuted<4>(table, cells, out);
    case 5:
      return AcrossPermuted<5>(table, cells, out);
    case 6:
      return AcrossPermuted<6>(table, cells, out);
    default:
      return AcrossPermuted<0>(table, cells, out);
  }
}

/// A cell's share of a pixel is the difference of the distribution at its two edges.
HWY_INLINE Floats share_between(Floats& below, Floats& z, Floats step) {
  z = hn::Add(z, step);
  const Floats next = normal_below(z);
  const Floats share = hn::Sub(next, below);
  below = next;
  return share;
}

void SpreadAcrossCurve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  const Floats ramp = hn::Iota(d, 0);
  for (int group = 0; group < curve.groups; ++group) {
    const float slope = (curve.cell[group + 1] - curve.cell[group]) * (1.0f / kGroup);
    const float pixels_a_cell = 1 / std::max(slope, 1e-6f);
    const Floats narrow_step = set(pixels_a_cell / curve.narrow_pixels);
    const Floats wide_step = set(pixels_a_cell / curve.wide_pixels);
    const Floats gain = set(slope / curve.cells_a_pixel);
    for (int x = 0; x < kGroup; x += lanes()) {
      const Floats cell =
          hn::MulAdd(set(slope), hn::Add(ramp, set(static_cast<float>(x))), set(curve.cell[group]));
      // Columns beside the line see the dark cells that follow it.
      const Floats start =
          hn::Min(hn::Max(hn::Floor(hn::Sub(cell, set(0.5f * kCellTaps - 0.5f))), set(-kCellPad)),
                  set(static_cast<float>(curve.cells + kCellPad - kGroup - kCellTaps)));
      const auto first = hn::ConvertTo(di, start);
      const int base = hn::GetLane(first);
      const auto step = hn::Sub(first, hn::Set(di, base));
      const auto lane = hn::IndicesFromVec(d, hn::Min(step, hn::Set(di, lanes() - 1)));
      Floats narrow_z = hn::Mul(hn::Sub(start, cell), narrow_step);
      Floats wide_z = hn::Mul(hn::Sub(start, cell), wide_step);
      Floats narrow_below = normal_below(narrow_z), wide_below = normal_below(wide_z);
      Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 6
      for (int t = 0; t < kCellTaps; ++t) {
        const Floats n = hn::TableLookupLanes(hn::LoadU(d, cells.narrow + base + t), lane);
        const Floats w = hn::TableLookupLanes(hn::LoadU(d, cells.wide + base + t), lane);
        sum.narrow = hn::MulAdd(n, share_between(narrow_below, narrow_z, narrow_step), sum.narrow);
        sum.wide = hn::MulAdd(w, share_between(wide_below, wide_z, wide_step), sum.wide);
      }
      hn::StoreU(hn::Mul(sum.narrow, gain), d, out.narrow + group * kGroup + x);
      hn::StoreU(hn::Mul(sum.wide, gain), d, out.wide + group * kGroup + x);
    }
  }
}

template <int kTaps>
HWY_INLINE void DownBy(int groups, int any_taps, const float* const* narrow_rows,
                       const float* const* wide_rows, const float* narrow_weight,
                       const float* wide_weight, float* out) {
  const int taps = kTaps > 0 ? kTaps : any_taps;
  for (int x = 0; x < groups * kGroup; x += lanes()) {
    Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 6
    for (int t = 0; t < taps; ++t) {
      sum.narrow = hn::MulAdd(set(narrow_weight[t]), hn::LoadU(d, narrow_rows[t] + x), sum.narrow);
      sum.wide = hn::MulAdd(set(wide_weight[t]), hn::LoadU(d, wide_rows[t] + x), sum.wide);
    }
    hn::StoreU(hn::Add(sum.narrow, sum.wide), d, out + x);
  }
}

void SpreadDown(int groups, int taps, const float* const* narrow_rows,
                const float* const* wide_rows, const float* narrow_weight, const float* wide_weight,
                float* out) {
  switch (taps) {
    case 2:
      return DownBy<2>(groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, out);
    case 3:
      return DownBy<3>(groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, out);
    case 4:
      return DownBy<4>(groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, out);
    default:
      return DownBy<0>(groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, out);
  }
}

void SpreadDownCurve(const DownCurve& curve, float* out) {
  constexpr float kLog2E = 1.44269504f, kInverseRoot2Pi = 0.39894228f;
  const Floats ramp = hn::Iota(d, 0);
  for (int group = 0; group < curve.groups; ++group) {
    const float from = curve.line[group], to = curve.line[group + 1];
    const float pitch = curve.pitch[group];
    const float narrow_lines = curve.narrow_pixels * pitch, wide_lines = curve.wide_pixels * pitch;
    const float brightness = kInverseRoot2Pi * pitch / curve.lines_a_pixel;
    const Floats narrow_fall = set(-0.5f * kLog2E / (narrow_lines * narrow_lines));
    const Floats wide_fall = set(-0.5f * kLog2E / (wide_lines * wide_lines));
    const int base = static_cast<int>(std::floor(0.5f * (from + to) - 0.5f * kLineTaps + 1.0f));
    for (int x = 0; x < kGroup; x += lanes()) {
      const Floats along = hn::Add(ramp, set(static_cast<float>(x)));
      Floats away = hn::MulAdd(set((to - from) * (1.0f / kGroup)), along,
                               set(from - static_cast<float>(base)));
      Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 4
      for (int t = 0; t < kLineTaps; ++t, away = hn::Sub(away, set(1.0f))) {
        const int row = ((base + t) & curve.ring_mask) * curve.ring_pitch + group * kGroup + x;
        const Floats q = hn::Mul(away, away);
        sum.narrow = hn::MulAdd(exp2_below(hn::Mul(q, narrow_fall)),
                                hn::LoadU(d, curve.narrow_ring + row), sum.narrow);
        sum.wide = hn::MulAdd(exp2_below(hn::Mul(q, wide_fall)),
                              hn::LoadU(d, curve.wide_ring + row), sum.wide);
      }
      const Floats narrow = hn::Mul(sum.narrow, set(brightness / narrow_lines));
      hn::StoreU(hn::MulAdd(sum.wide, set(brightness / wide_lines), narrow), d,
                 out + group * kGroup + x);
    }
  }
}

struct Colour {
  Floats c[3];
};

/// The colour of `kLanes` pixels from x on, past mask and glass.
template <int kGuns>
HWY_INLINE Colour finished(const FinishRow& row, int x) {
  const hn::Rebind<std::uint8_t, F> d8;
  Colour sum{{set(row.ambient[0]), set(row.ambient[1]), set(row.ambient[2])}};
  for (int gun = 0; gun < kGuns; ++gun) {
    Floats light = hn::LoadU(d, row.light[gun] + x);
    if (row.mask[gun]) {
      const auto open = hn::PromoteTo(di, hn::LoadU(d8, row.mask[gun] + x));
      light = hn::Mul(light, hn::Mul(hn::ConvertTo(d, open), set(1.0f / 64)));
    }
    if (row.glow[gun]) {
      const Floats above = hn::LoadU(d, row.glow[gun] + x);
      const Floats below = hn::LoadU(d, row.glow_below[gun] + x);
      light = hn::Add(light, hn::MulAdd(hn::Sub(below, above), set(row.glow_share), above));
    }
    for (int c = 0; c < 3; ++c) sum.c[c] = hn::MulAdd(light, set(row.colour[gun][c]), sum.c[c]);
  }
  return sum;
}

template <int kGuns>
HWY_INLINE void FinishLightOf(const FinishRow& row, int n, bool add, LinearRgb* out) {
  float* to = &out->r;
  HWY_ALIGN float tail[3 * kGroup];
  for (int x = 0; x < n; x += lanes()) {
    const Colour colour = finished<kGuns>(row, x);
    const int count = 3 * std::min(lanes(), n - x);
    if (!add && count == 3 * lanes()) {
      hn::StoreInterleaved3(colour.c[0], colour.c[1], colour.c[2], d, to + 3 * x);
      continue;
    }
    hn::StoreInterleaved3(colour.c[0], colour.c[1], colour.c[2], d, tail);
    for (int i = 0; i < count; ++i) to[3 * x + i] = add ? to[3 * x + i] + tail[i] : tail[i];
  }
}

void FinishLight(const FinishRow& row, int n, bool add, LinearRgb* out) {
  row.guns == 1 ? FinishLightOf<1>(row, n, add, out) : FinishLightOf<3>(row, n, add, out);
}

/// sRGB codes by a polynomial in the square root, and the straight line below.
HWY_INLINE hn::Vec<I> code_of(Floats x) {
  x = hn::Min(hn::Max(x, hn::Zero(d)), set(1.0f));
  const Floats s = hn::Sqrt(x);
  Floats p = hn::MulAdd(set(131.909793f), s, set(-414.026958f));
  p = hn::MulAdd(p, s, set(518.046379f));
  p = hn::MulAdd(p, s, set(-357.695930f));
  p = hn::MulAdd(p, s, set(387.077217f));
  p = hn::MulAdd(p, s, set(-10.2279443f));
  const Floats straight = hn::Mul(x, set(12.92f * 255));
  return hn::NearestInt(hn::IfThenElse(hn::Lt(x, set(0.0031308f)), straight, p));
}

template <int kGuns>
HWY_INLINE void FinishEncodedOf(const FinishRow& row, int n, float gain, Srgb8* out) {
  std::uint32_t* to = reinterpret_cast<std::uint32_t*>(out);
  const hn::RebindToUnsigned<F> du;
  HWY_ALIGN std::uint32_t tail[kGroup];
  for (int x = 0; x < n; x += lanes()) {
    const Colour colour = finished<kGuns>(row, x);
    const auto r = code_of(hn::Mul(colour.c[0], set(gain)));
    const auto g = code_of(hn::Mul(colour.c[1], set(gain)));
    const auto b = code_of(hn::Mul(colour.c[2], set(gain)));
    const auto packed =
        hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)),
               hn::Or(hn::ShiftLeft<16>(b), hn::Set(di, static_cast<std::int32_t>(0xff000000u))));
    if (x + lanes() <= n) {
      hn::StoreU(hn::BitCast(du, packed), du, to + x);
    } else {
      hn::StoreU(hn::BitCast(du, packed), du, tail);
      std::copy_n(tail, n - x, to + x);
    }
  }
}

void FinishEncoded(const FinishRow& row, int n, float gain, Srgb8* out) {
  row.guns == 1 ? FinishEncodedOf<1>(row, n, gain, out) : FinishEncodedOf<3>(row, n, gain, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(SpreadAcross);
HWY_EXPORT(SpreadAcrossCurve);
HWY_EXPORT(SpreadDown);
HWY_EXPORT(SpreadDownCurve);
HWY_EXPORT(FinishLight);
HWY_EXPORT(FinishEncoded);

void spread_across(const AcrossTable& table, CellRows cells, SpreadRows out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcross)(table, cells, out);
}
void spread_across_curve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcrossCurve)(curve, cells, out);
}
void spread_down(int groups, int taps, const float* const* narrow_rows,
                 const float* const* wide_rows, const float* narrow_weight,
                 const float* wide_weight, float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadDown)
  (groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, out);
}
void spread_down_curve(const DownCurve& curve, float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadDownCurve)(curve, out);
}
void finish_light(const FinishRow& row, int n, bool add, LinearRgb* out) {
  HWY_DYNAMIC_DISPATCH(FinishLight)(row, n, add, out);
}
void finish_encoded(const FinishRow& row, int n, float gain, Srgb8* out) {
  HWY_DYNAMIC_DISPATCH(FinishEncoded)(row, n, gain, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
