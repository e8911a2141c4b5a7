#include "display/tube/curve_kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube/curve_kernels.cpp"
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
/// Of several at once, step by step: each step waits for the one before.
template <int kCount>
HWY_INLINE void normal_below(Floats (&z)[kCount]) {
  static constexpr float kSeries[] = {-1.4823849e-06f, 5.5700488e-05f, -0.00093099633f,
                                      0.0094104743f,   -0.066073838f,  0.39984757f};
  Floats q[kCount], p[kCount];
#pragma GCC unroll 16
  for (int i = 0; i < kCount; ++i) {
    z[i] = hn::Min(hn::Max(z[i], set(-3.0f)), set(3.0f));
    q[i] = hn::Mul(z[i], z[i]);
    p[i] = set(kSeries[0]);
  }
#pragma GCC unroll 5
  for (int power = 1; power < 6; ++power) {
#pragma GCC unroll 16
    for (int i = 0; i < kCount; ++i) p[i] = hn::MulAdd(p[i], q[i], set(kSeries[power]));
  }
#pragma GCC unroll 16
  for (int i = 0; i < kCount; ++i) z[i] = hn::Mul(p[i], z[i]);
}

struct Pair {
  Floats narrow, wide;
};

/// A tile takes a few cells of each line: too few for the processor to see where they go on.
HWY_INLINE void prefetch_next_line(const CellRows& cells, int cell) {
  hwy::Prefetch(cells.narrow + cells.next_line + cell);
  hwy::Prefetch(cells.wide + cells.next_line + cell);
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
  constexpr int kEdges = kTaps - 1;  // between the cells
  const Floats before = hn::Sub(place.start, place.cell);
  Floats narrow_below[kEdges], wide_below[kEdges];
#pragma GCC unroll 5
  for (int edge = 0; edge < kEdges; ++edge) {
    const Floats at = hn::Add(before, set(static_cast<float>(edge + 1)));
    narrow_below[edge] = hn::Mul(at, place.narrow_step);
    wide_below[edge] = hn::Mul(at, place.wide_step);
  }
  normal_below(narrow_below);
  normal_below(wide_below);
  const Floats half = set(0.5f);
  Floats narrow = hn::Mul(cells.narrow(0), hn::Add(narrow_below[0], half));
  Floats wide = hn::Mul(cells.wide(0), hn::Add(wide_below[0], half));
#pragma GCC unroll 5
  for (int t = 1; t < kEdges; ++t) {
    narrow = hn::MulAdd(cells.narrow(t), hn::Sub(narrow_below[t], narrow_below[t - 1]), narrow);
    wide = hn::MulAdd(cells.wide(t), hn::Sub(wide_below[t], wide_below[t - 1]), wide);
  }
  narrow = hn::MulAdd(cells.narrow(kEdges), hn::Sub(half, narrow_below[kEdges - 1]), narrow);
  wide = hn::MulAdd(cells.wide(kEdges), hn::Sub(half, wide_below[kEdges - 1]), wide);
  return {narrow, wide};
}

template <int kTaps>
HWY_INLINE void AlongCurve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  const Floats ramp = lane_numbers(d);
  // Columns beside the line see the dark cells that lie there.
  const Floats least = set(-kCellPad);
  const Floats most = set(static_cast<float>(curve.cells + kCellPad - kGroup - kTaps));
  const float pixels_a_cell = 1 / curve.cells_a_pixel;
  const float narrow = 1 / curve.narrow_pixels, wide = 1 / curve.wide_pixels;
  const int groups = curve.groups;
  const float* const node = curve.cell;
  for (int group = 0; group < groups; ++group) {
    const float slope = (node[group + 1] - node[group]) * (1.0f / kGroup);
    const float stretch = 1 / std::max(slope, 1e-6f);  // pixels a cell
    const Floats gain = set(slope * pixels_a_cell);
    CurvePlace place{};
    place.narrow_step = set(stretch * narrow);
    place.wide_step = set(stretch * wide);
    for (int x = 0; x < kGroup; x += lanes()) {
      place.cell =
          hn::MulAdd(set(slope), hn::Add(ramp, set(static_cast<float>(x))), set(node[group]));
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

/// The weights of a group's columns, each its own.
struct SteepWeights {
  LineProfile profile;
  float away, step;  // of the first column from the first line; from column to column
  HWY_INLINE void at(int x, int tap, Floats& narrow, Floats& wide) const {
    const Floats column = hn::Add(lane_numbers(d), set(static_cast<float>(x)));
    const Floats first = hn::MulAdd(set(step), column, set(away));
    const Floats from_line = hn::Sub(first, set(static_cast<float>(tap)));
    narrow = profile.narrow(from_line);
    wide = profile.wide(from_line);
  }
};

/// The same where the lines are so nearly level that weights change evenly along a group.
struct LevelWeights {
  float from[2 * kLineTaps], to[2 * kLineTaps];  // less `from`
  LevelWeights(const LineProfile& profile, float away, float fall) {
    WeighNode(profile, away, from);
    WeighNode(profile, away + fall, to);
    for (int x = 0; x < 2 * kLineTaps; x += lanes()) {
      hn::StoreU(hn::Sub(hn::LoadU(d, to + x), hn::LoadU(d, from + x)), d, to + x);
    }
  }
  HWY_INLINE void at(int x, int tap, Floats& narrow, Floats& wide) const {
    const Floats column =
        hn::Mul(hn::Add(lane_numbers(d), set(static_cast<float>(x))), set(1.0f / kGroup));
    narrow = hn::MulAdd(set(to[tap]), column, set(from[tap]));
    wide = hn::MulAdd(set(to[kLineTaps + tap]), column, set(from[kLineTaps + tap]));
  }
};

/// A group's columns in every ring. @param first its first line
template <int kRings, typename Weights>
HWY_INLINE void SumLines(const Weights& weights, const LineRing* rings, int first, int group) {
  int row[kRings][kLineTaps];
  for (int r = 0; r < kRings; ++r) {
    for (int t = 0; t < kLineTaps; ++t) {
      row[r][t] = ((first + t) & rings[r].mask) * rings[r].pitch + group * kGroup;
    }
  }
  for (int x = 0; x < kGroup; x += lanes()) {
    Floats narrow_sum[kRings], wide_sum[kRings];
#pragma GCC unroll 3
    for (int r = 0; r < kRings; ++r) narrow_sum[r] = wide_sum[r] = hn::Zero(d);
#pragma GCC unroll 4
    for (int t = 0; t < kLineTaps; ++t) {
      Floats narrow, wide;
      weights.at(x, t, narrow, wide);
#pragma GCC unroll 3
      for (int r = 0; r < kRings; ++r) {
        const Floats narrow_line = hn::LoadU(d, rings[r].narrow + row[r][t] + x);
        const Floats wide_line = hn::LoadU(d, rings[r].wide + row[r][t] + x);
        narrow_sum[r] = hn::MulAdd(narrow, narrow_line, narrow_sum[r]);
        wide_sum[r] = hn::MulAdd(wide, wide_line, wide_sum[r]);
      }
    }
#pragma GCC unroll 3
    for (int r = 0; r < kRings; ++r) {
      hn::StoreU(hn::Add(narrow_sum[r], wide_sum[r]), d, rings[r].out + group * kGroup + x);
    }
  }
}

template <int kRings>
HWY_INLINE void DownCurve(const LineGrid& any_grid, const LineRing* any_rings) {
  constexpr float kLog2E = 1.44269504f, kInverseRoot2Pi = 0.39894228f;
  const LineGrid grid = any_grid;  // nothing that is stored aliases a copy
  LineRing rings[kRings];
  std::copy_n(any_rings, kRings, rings);
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
    const float square = 1 / (pitch * pitch);
    profile.narrow_fall = -0.5f * kLog2E * square * narrow_least;
    profile.wide_fall = -0.5f * kLog2E * square * wide_least;
    const int first = static_cast<int>(std::floor(0.5f * (from + to) - 0.5f * kLineTaps + 1.0f));
    const float away = from - static_cast<float>(first);
    // Halfway between, a Gaussian's height differs by (fall / deviation)^2 / 8.
    constexpr float kLevel = 0.17f;
    if ((to - from) * (to - from) * square * narrow_least < kLevel * kLevel) {
      SumLines<kRings>(LevelWeights(profile, away, to - from), rings, first, group);
    } else {
      SumLines<kRings>(SteepWeights{profile, away, (to - from) * (1.0f / kGroup)}, rings, first,
                       group);
    }
    from = to;
  }
}

void SpreadDownCurve(const LineGrid& grid, std::span<const LineRing> rings) {
  switch (rings.size()) {
    case 1:
      return DownCurve<1>(grid, rings.data());
    case 2:
      return DownCurve<2>(grid, rings.data());
    default:
      return DownCurve<3>(grid, rings.data());
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(SpreadAcrossCurve);
HWY_EXPORT(SpreadDownCurve);

void spread_across_curve(const AcrossCurve& curve, CellRows cells, SpreadRows out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcrossCurve)(curve, cells, out);
}
void spread_down_curve(const LineGrid& grid, std::span<const LineRing> rings) {
  HWY_DYNAMIC_DISPATCH(SpreadDownCurve)(grid, rings);
}

}  // namespace kinescope
#endif  // HWY_ONCE
