#include "display/tube/spread_kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube/spread_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"

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

/// 2^x for x below 0, to 8e-5, and 2^-126 for less. Adding 1.5 * 2^23 leaves the whole part in the
/// lowest bits.
HWY_INLINE Floats exp2_below(Floats x) {
  x = hn::Max(x, set(-126.0f));
  const Floats shifter = set(12582912.0f);
  const Floats shifted = hn::Add(x, shifter);
  const Floats f = hn::Sub(x, hn::Sub(shifted, shifter));
  Floats p = hn::MulAdd(set(0.055088767f), f, set(0.24260466f));
  p = hn::MulAdd(p, f, set(0.69327628f));
  p = hn::MulAdd(p, f, set(0.99992890f));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
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

/// A tile takes a few cells of each line: too few for the processor to see where they go on.
HWY_INLINE void prefetch_next_line(const CellRows& cells, int cell) {
  hwy::Prefetch(cells.narrow + cells.next_line + cell);
  hwy::Prefetch(cells.wide + cells.next_line + cell);
}

/// The cells of a group's columns within one vector of them, or tap after tap. kTaps known lets the
/// compiler unroll; 0 takes any number.
template <int kTaps, bool kOneVector>
void AcrossPermuted(const AcrossTable& any_table, CellRows cells, SpreadRows out) {
  const AcrossTable table = any_table;  // nothing that is stored aliases a copy
  const int taps = kTaps > 0 ? kTaps : table.taps;
  const auto one = hn::Set(di, 1);
  for (int x = 0; x < table.groups * kGroup; x += lanes()) {
    const int base = table.start[x];
    auto lane = hn::Sub(hn::LoadU(di, table.start + x), hn::Set(di, base));
    prefetch_next_line(cells, base);
    Floats n = hn::LoadU(d, cells.narrow + base), w = hn::LoadU(d, cells.wide + base);
    Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 6
    for (int t = 0; t < taps; ++t) {
      if (!kOneVector) {
        n = hn::LoadU(d, cells.narrow + base + t);
        w = hn::LoadU(d, cells.wide + base + t);
      }
      const auto at = hn::IndicesFromVec(d, lane);
      sum.narrow = hn::MulAdd(hn::TableLookupLanes(n, at),
                              hn::LoadU(d, table.narrow + t * table.pitch + x), sum.narrow);
      sum.wide = hn::MulAdd(hn::TableLookupLanes(w, at),
                            hn::LoadU(d, table.wide + t * table.pitch + x), sum.wide);
      if (kOneVector) lane = hn::Add(lane, one);
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
  if (table.span >= lanes()) return AcrossGathered(table, cells, out);
  const bool one = table.span + table.taps <= lanes();
  switch (table.taps) {
    case 3:
      return one ? AcrossPermuted<3, true>(table, cells, out)
                 : AcrossPermuted<3, false>(table, cells, out);
    case 4:
      return one ? AcrossPermuted<4, true>(table, cells, out)
                 : AcrossPermuted<4, false>(table, cells, out);
    case 5:
      return one ? AcrossPermuted<5, true>(table, cells, out)
                 : AcrossPermuted<5, false>(table, cells, out);
    default:
      return one ? AcrossPermuted<0, true>(table, cells, out)
                 : AcrossPermuted<0, false>(table, cells, out);
  }
}

/// One group's columns: where they lie, and how much of a pixel's width a deviation is.
struct CurvePlace {
  Floats cell, start;
  Floats narrow_step, wide_step;  // deviations a cell
};

/// Cells that lie within a vector of the first column's.
struct NearCells {
  NearCells(CellRows rows, hn::VFromD<decltype(di)> first)
      : cells(rows),
        base(hn::GetLane(first)),
        lane(hn::IndicesFromVec(d, hn::Sub(first, hn::Set(di, base)))) {
    prefetch_next_line(rows, base);
  }
  Floats narrow(int tap) const { return at(cells.narrow + base + tap); }
  Floats wide(int tap) const { return at(cells.wide + base + tap); }
  Floats at(const float* from) const { return hn::TableLookupLanes(hn::LoadU(d, from), lane); }

  CellRows cells;
  int base;
  decltype(hn::IndicesFromVec(d, hn::Zero(di))) lane;
};

/// Cells further apart than that.
struct FarCells {
  FarCells(CellRows rows, hn::VFromD<decltype(di)> first) : cells(rows), start(first) {}
  Floats narrow(int tap) const { return hn::GatherIndex(d, cells.narrow + tap, start); }
  Floats wide(int tap) const { return hn::GatherIndex(d, cells.wide + tap, start); }

  CellRows cells;
  hn::VFromD<decltype(di)> start;
};

/// A cell's share of a pixel is the difference of the distribution at its two edges. All of it lies
/// between the first cell's beginning and the last one's end: white is even.
template <int kTaps, typename Cells>
HWY_INLINE Pair CurvedSum(const CurvePlace& place, const Cells& cells) {
  const Floats before = hn::Sub(place.start, place.cell);
  Floats narrow_z = hn::Mul(before, place.narrow_step), wide_z = hn::Mul(before, place.wide_step);
  Floats narrow_below = set(-0.5f), wide_below = set(-0.5f);
  Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 6
  for (int t = 0; t < kTaps; ++t) {
    const bool last = t + 1 == kTaps;
    narrow_z = hn::Add(narrow_z, place.narrow_step);
    wide_z = hn::Add(wide_z, place.wide_step);
    const Floats narrow_next = last ? set(0.5f) : normal_below(narrow_z);
    const Floats wide_next = last ? set(0.5f) : normal_below(wide_z);
    sum.narrow = hn::MulAdd(cells.narrow(t), hn::Sub(narrow_next, narrow_below), sum.narrow);
    sum.wide = hn::MulAdd(cells.wide(t), hn::Sub(wide_next, wide_below), sum.wide);
    narrow_below = narrow_next;
    wide_below = wide_next;
  }
  return sum;
}

template <int kTaps>
HWY_INLINE void AlongCurve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  const Floats ramp = lane_numbers(d);
  // Columns beside the line see the dark cells that lie there.
  const Floats least = set(-kCellPad);
  const Floats most = set(static_cast<float>(curve.cells + kCellPad - kGroup - kTaps));
  for (int group = 0; group < curve.groups; ++group) {
    const float slope = (curve.cell[group + 1] - curve.cell[group]) * (1.0f / kGroup);
    const float pixels_a_cell = 1 / std::max(slope, 1e-6f);
    const Floats gain = set(slope / curve.cells_a_pixel);
    CurvePlace place{};
    place.narrow_step = set(pixels_a_cell / curve.narrow_pixels);
    place.wide_step = set(pixels_a_cell / curve.wide_pixels);
    for (int x = 0; x < kGroup; x += lanes()) {
      place.cell =
          hn::MulAdd(set(slope), hn::Add(ramp, set(static_cast<float>(x))), set(curve.cell[group]));
      const Floats start = hn::Floor(hn::Sub(place.cell, set(0.5f * kTaps - 0.5f)));
      place.start = hn::Min(hn::Max(start, least), most);
      const auto first = hn::ConvertTo(di, place.start);
      const Pair sum = slope <= 1 ? CurvedSum<kTaps>(place, NearCells(cells, first))
                                  : CurvedSum<kTaps>(place, FarCells(cells, first));
      hn::StoreU(hn::Mul(sum.narrow, gain), d, out.narrow + group * kGroup + x);
      hn::StoreU(hn::Mul(sum.wide, gain), d, out.wide + group * kGroup + x);
    }
  }
}

void SpreadAcrossCurve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  switch (curve.taps) {
    case 4:
      return AlongCurve<4>(curve, cells, out);
    case 5:
      return AlongCurve<5>(curve, cells, out);
    default:
      return AlongCurve<6>(curve, cells, out);
  }
}

template <int kTaps, bool kAdd>
void DownBy(int groups, int any_taps, const float* const* narrow_rows,
            const float* const* wide_rows, const float* narrow_weight, const float* wide_weight,
            float* out) {
  const int taps = kTaps > 0 ? kTaps : any_taps;
  // In registers: what is stored might alias them.
  constexpr int kRows = kTaps > 0 ? kTaps : 64;
  Floats narrow_by[kRows], wide_by[kRows];
  const float *narrow[kRows], *wide[kRows];
#pragma GCC unroll 6
  for (int t = 0; t < taps; ++t) {
    narrow_by[t] = set(narrow_weight[t]);
    wide_by[t] = set(wide_weight[t]);
    narrow[t] = narrow_rows[t];
    wide[t] = wide_rows[t];
  }
  for (int x = 0; x < groups * kGroup; x += lanes()) {
    Floats narrow_sum = kAdd ? hn::LoadU(d, out + x) : hn::Zero(d), wide_sum = hn::Zero(d);
#pragma GCC unroll 6
    for (int t = 0; t < taps; ++t) {
      narrow_sum = hn::MulAdd(narrow_by[t], hn::LoadU(d, narrow[t] + x), narrow_sum);
      wide_sum = hn::MulAdd(wide_by[t], hn::LoadU(d, wide[t] + x), wide_sum);
    }
    hn::StoreU(hn::Add(narrow_sum, wide_sum), d, out + x);
  }
}

void SpreadDown(int groups, int taps, const float* const* narrow_rows,
                const float* const* wide_rows, const float* narrow_weight, const float* wide_weight,
                bool add, float* out) {
  const auto by = [=](auto down) {
    down(groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, out);
  };
  if (add) return by(DownBy<0, true>);
  switch (taps) {
    case 2:
      return by(DownBy<2, false>);
    case 3:
      return by(DownBy<3, false>);
    case 4:
      return by(DownBy<4, false>);
    default:
      return by(DownBy<0, false>);
  }
}

/// The spot's profile down, of lines that lie `away` from a row.
struct LineProfile {
  float narrow_fall, wide_fall;      // of the exponent of 2, by distance squared
  float narrow_height, wide_height;  // Gaussians are as bright as they are narrow, lines as they
                                     // are wide apart
  Floats narrow(Floats away) const { return weight(away, set(narrow_fall), set(narrow_height)); }
  Floats wide(Floats away) const { return weight(away, set(wide_fall), set(wide_height)); }
  static HWY_INLINE Floats weight(Floats away, Floats fall, Floats height) {
    return hn::Mul(exp2_below(hn::Mul(hn::Mul(away, away), fall)), height);
  }
};

/// A group's weights, each column's its own. @param away of the first column from the first line
HWY_INLINE void WeighColumns(const LineProfile& profile, float away, float step, float* narrow,
                             float* wide) {
  for (int x = 0; x < kGroup; x += lanes()) {
    const Floats ramp = hn::Add(lane_numbers(d), set(static_cast<float>(x)));
    Floats at = hn::MulAdd(set(step), ramp, set(away));
#pragma GCC unroll 4
    for (int t = 0; t < kLineTaps; ++t, at = hn::Sub(at, set(1.0f))) {
      hn::StoreU(profile.narrow(at), d, narrow + t * kGroup + x);
      hn::StoreU(profile.wide(at), d, wide + t * kGroup + x);
    }
  }
}

/// Both Gaussians' weights of all lines at one place: a lane each, the narrow one's first.
HWY_INLINE void WeighNode(const LineProfile& p, float away, float* weights) {
  for (int x = 0; x < 2 * kLineTaps; x += lanes()) {
    const Floats lane = hn::Add(lane_numbers(d), set(static_cast<float>(x)));
    const auto wide = hn::Ge(lane, set(static_cast<float>(kLineTaps)));
    const Floats line = hn::Sub(lane, hn::IfThenElseZero(wide, set(kLineTaps)));
    const Floats fall = hn::IfThenElse(wide, set(p.wide_fall), set(p.narrow_fall));
    const Floats height = hn::IfThenElse(wide, set(p.wide_height), set(p.narrow_height));
    hn::StoreU(LineProfile::weight(hn::Sub(set(away), line), fall, height), d, weights + x);
  }
}

/// The same where the lines are so nearly level that weights change evenly along a group.
HWY_INLINE void WeighLevelColumns(const LineProfile& profile, float away, float step, float* narrow,
                                  float* wide) {
  HWY_ALIGN float from[2 * kLineTaps], to[2 * kLineTaps];
  WeighNode(profile, away, from);
  WeighNode(profile, away + kGroup * step, to);
  for (int x = 0; x < kGroup; x += lanes()) {
    const Floats ramp =
        hn::Mul(hn::Add(lane_numbers(d), set(static_cast<float>(x))), set(1.0f / kGroup));
#pragma GCC unroll 4
    for (int t = 0; t < kLineTaps; ++t) {
      const auto between = [&](int i) {
        return hn::MulAdd(hn::Sub(set(to[i]), set(from[i])), ramp, set(from[i]));
      };
      hn::StoreU(between(t), d, narrow + t * kGroup + x);
      hn::StoreU(between(kLineTaps + t), d, wide + t * kGroup + x);
    }
  }
}

void FindLineWeights(const LineGrid& any_grid, int* base_out, float* narrow_out, float* wide_out) {
  constexpr float kLog2E = 1.44269504f, kInverseRoot2Pi = 0.39894228f;
  const LineGrid grid = any_grid;  // nothing that is stored aliases a copy
  const auto line_at = [&](int node) {
    return grid.above[node] + grid.share * (grid.below[node] - grid.above[node]);
  };
  const float narrow_least = 1 / (grid.narrow_pixels * grid.narrow_pixels);
  const float wide_least = 1 / (grid.wide_pixels * grid.wide_pixels);
  LineProfile profile{};
  profile.narrow_height = kInverseRoot2Pi / (grid.lines_a_pixel * grid.narrow_pixels);
  profile.wide_height = kInverseRoot2Pi / (grid.lines_a_pixel * grid.wide_pixels);
  float from = line_at(0);
  for (int group = 0; group < grid.groups; ++group) {
    const float to = line_at(group + 1);
    const float fall =
        (grid.below[group] - grid.above[group]) + (grid.below[group + 1] - grid.above[group + 1]);
    const float pitch = std::max(fall * (0.5f / kGroup), grid.least_pitch);
    const float lines = -0.5f * kLog2E / (pitch * pitch);
    profile.narrow_fall = lines * narrow_least;
    profile.wide_fall = lines * wide_least;
    const int base = static_cast<int>(std::floor(0.5f * (from + to) - 0.5f * kLineTaps + 1.0f));
    base_out[group] = base;
    const float away = from - static_cast<float>(base), step = (to - from) * (1.0f / kGroup);
    float* const narrow = narrow_out + group * kLineTaps * kGroup;
    float* const wide = wide_out + group * kLineTaps * kGroup;
    // Halfway between, a Gaussian's height differs by (fall / deviation)^2 / 8.
    const float deviations = (to - from) / (pitch * grid.narrow_pixels);
    constexpr float kLevel = 0.17f;
    if (deviations * deviations < kLevel * kLevel) {
      WeighLevelColumns(profile, away, step, narrow, wide);
    } else {
      WeighColumns(profile, away, step, narrow, wide);
    }
    from = to;
  }
}

void SpreadDownCurve(int groups, const LineWeights& weights, const LineRing& ring, float* out) {
  for (int group = 0; group < groups; ++group) {
    int row[kLineTaps];
    for (int t = 0; t < kLineTaps; ++t) {
      row[t] = ((weights.base[group] + t) & ring.mask) * ring.pitch + group * kGroup;
    }
    for (int x = 0; x < kGroup; x += lanes()) {
      Pair sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 4
      for (int t = 0; t < kLineTaps; ++t) {
        const int at = (group * kLineTaps + t) * kGroup + x;
        sum.narrow = hn::MulAdd(hn::LoadU(d, weights.narrow + at),
                                hn::LoadU(d, ring.narrow + row[t] + x), sum.narrow);
        sum.wide = hn::MulAdd(hn::LoadU(d, weights.wide + at), hn::LoadU(d, ring.wide + row[t] + x),
                              sum.wide);
      }
      hn::StoreU(hn::Add(sum.narrow, sum.wide), d, out + group * kGroup + x);
    }
  }
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
HWY_EXPORT(FindLineWeights);
HWY_EXPORT(SpreadDownCurve);

void spread_across(const AcrossTable& table, CellRows cells, SpreadRows out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcross)(table, cells, out);
}
void spread_across_curve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcrossCurve)(curve, cells, out);
}
void spread_down(int groups, int taps, const float* const* narrow_rows,
                 const float* const* wide_rows, const float* narrow_weight,
                 const float* wide_weight, bool add, float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadDown)
  (groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, add, out);
}
void find_line_weights(const LineGrid& grid, int* base, float* narrow, float* wide) {
  HWY_DYNAMIC_DISPATCH(FindLineWeights)(grid, base, narrow, wide);
}
void spread_down_curve(int groups, const LineWeights& weights, const LineRing& ring, float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadDownCurve)(groups, weights, ring, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
