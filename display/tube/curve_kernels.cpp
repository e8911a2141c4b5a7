#include "display/tube/curve_kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube/curve_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "display/eight_floats-inl.h"
#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

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
    // Eight columns within eight cells, however their places are rounded. Beyond the glass a bent
    // line may run back.
    const bool near = slope >= 0 && slope < 0.98f;
    CurvePlace place{};
    place.narrow_step = set(stretch * narrow);
    place.wide_step = set(stretch * wide);
    for (int x = 0; x < kGroup; x += lanes()) {
      place.cell =
          hn::MulAdd(set(slope), hn::Add(ramp, set(static_cast<float>(x))), set(node[group]));
      const Floats start = hn::Floor(hn::Sub(place.cell, set(0.5f * kTaps - 0.5f)));
      place.start = hn::Min(hn::Max(start, least), most);
      const auto first = hn::ConvertTo(di, place.start);
      const Pair sum = near ? CurvedSum<kTaps>(place, NearCells(cells, first))
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

/// The spot's profile down, of lines a pixel apart: both Gaussians' 4 lines, the narrow one's
/// first.
struct LineProfile {
  HWY_ALIGN float fall[2 * kLineTaps];    // of the exponent of 2, by distance squared
  HWY_ALIGN float height[2 * kLineTaps];  // Gaussians are as bright as they are narrow, lines as
                                          // they are wide apart
  HWY_ALIGN float line[2 * kLineTaps];
  explicit LineProfile(const LineGrid& grid) {
    constexpr float kLog2E = 1.44269504f, kInverseRoot2Pi = 0.39894228f;
    for (int i = 0; i < 2 * kLineTaps; ++i) {
      const float pixels = i < kLineTaps ? grid.narrow_pixels : grid.wide_pixels;
      fall[i] = -0.5f * kLog2E / (pixels * pixels);
      height[i] = kInverseRoot2Pi / (grid.lines_a_pixel * pixels);
      line[i] = static_cast<float>(i % kLineTaps);
    }
  }
};

/// Weights at one place, `away` from the first line, where lines lie 1 / sqrt(square) pixels apart.
HWY_INLINE void WeighNode(const LineProfile& profile, float away, float square, float* weights) {
  for (int x = 0; x < 2 * kLineTaps; x += lanes()) {
    const Floats from_line = hn::Sub(set(away), hn::Load(d, profile.line + x));
    const Floats fall = hn::Mul(hn::Load(d, profile.fall + x), set(square));
    const Floats power = exp2_below(hn::Mul(hn::Mul(from_line, from_line), fall));
    hn::Store(hn::Mul(power, hn::Load(d, profile.height + x)), d, weights + x);
  }
}

/// The weights of a group's columns, each its own.
struct SteepWeights {
  const LineProfile& profile;
  float away, step;  // of the first column from the first line; from column to column
  float square;
  HWY_INLINE Floats of(Floats column, int i) const {
    const Floats first = hn::MulAdd(set(step), column, set(away));
    const Floats from_line = hn::Sub(first, set(profile.line[i]));
    const Floats fall = set(profile.fall[i] * square);
    return hn::Mul(exp2_below(hn::Mul(hn::Mul(from_line, from_line), fall)),
                   set(profile.height[i]));
  }
};

/// The same where the lines are so nearly level that weights change evenly along a group.
struct LevelWeights {
  const float *from, *rise;  // a column
  HWY_INLINE Floats of(Floats column, int i) const {
    return hn::MulAdd(set(rise[i]), column, set(from[i]));
  }
};

/// A group's columns in every ring. @param first its first line
template <int kRings, typename Weights>
HWY_INLINE void SumLines(const Weights& weights, const LineRing& ring, const LineRows* rows,
                         int first, int group) {
  std::ptrdiff_t at[kLineTaps];
  for (int t = 0; t < kLineTaps; ++t) at[t] = ((first + t) & ring.mask) * ring.pitch;
  for (int x = 0; x < kGroup; x += lanes()) {
    const Floats column = hn::Add(lane_numbers(d), set(static_cast<float>(x)));
    Floats narrow_sum[kRings], wide_sum[kRings];
#pragma GCC unroll 3
    for (int r = 0; r < kRings; ++r) narrow_sum[r] = wide_sum[r] = hn::Zero(d);
#pragma GCC unroll 4
    for (int t = 0; t < kLineTaps; ++t) {
      const Floats narrow = weights.of(column, t), wide = weights.of(column, kLineTaps + t);
      const std::ptrdiff_t place = at[t] + group * kGroup + x;
#pragma GCC unroll 3
      for (int r = 0; r < kRings; ++r) {
        narrow_sum[r] = hn::MulAdd(narrow, hn::LoadU(d, rows[r].narrow + place), narrow_sum[r]);
        wide_sum[r] = hn::MulAdd(wide, hn::LoadU(d, rows[r].wide + place), wide_sum[r]);
      }
    }
#pragma GCC unroll 3
    for (int r = 0; r < kRings; ++r) {
      hn::StoreU(hn::Add(narrow_sum[r], wide_sum[r]), d, rows[r].out + group * kGroup + x);
    }
  }
}

template <int kRings>
HWY_INLINE void DownCurve(const LineGrid& any_grid, const LineRing& any_ring,
                          const LineRows* any_rows) {
  const LineGrid grid = any_grid;  // nothing that is stored aliases a copy
  const LineRing ring = any_ring;
  LineRows rows[kRings];
  std::copy_n(any_rows, kRings, rows);
  const LineProfile profile(grid);
  HWY_ALIGN float nodes[2][2 * kLineTaps], rise[2 * kLineTaps];
  const auto line_at = [&](int node) {
    return grid.above[node] + grid.share * (grid.below[node] - grid.above[node]);
  };
  const auto square_at = [&](int node) {
    const float fall = (grid.below[node] - grid.above[node]) * (1.0f / kGroup);
    const float pitch = std::max(fall, grid.least_pitch);
    return 1 / (pitch * pitch);
  };
  // Halfway between nodes, a Gaussian's height differs by (fall / deviation)^2 / 8.
  constexpr float kLevel = 0.17f;
  const float level = kLevel * kLevel * grid.narrow_pixels * grid.narrow_pixels;
  float from = line_at(0), square = square_at(0);
  int weighed = -1;  // the first line of the weights at the group's first node, if `known`
  bool known = false;
  for (int group = 0; group < grid.groups; ++group) {
    const float to = line_at(group + 1), next_square = square_at(group + 1);
    const int first = static_cast<int>(std::floor(0.5f * (from + to) - 0.5f * kLineTaps + 1.0f));
    const float away = from - static_cast<float>(first), fall = to - from;
    if (fall * fall * square < level) {
      float *const left = nodes[group & 1], *const right = nodes[~group & 1];
      if (!known || weighed != first) WeighNode(profile, away, square, left);
      WeighNode(profile, away + fall, next_square, right);
      for (int x = 0; x < 2 * kLineTaps; x += lanes()) {
        const Floats all = hn::Sub(hn::Load(d, right + x), hn::Load(d, left + x));
        hn::Store(hn::Mul(all, set(1.0f / kGroup)), d, rise + x);
      }
      SumLines<kRings>(LevelWeights{left, rise}, ring, rows, first, group);
      weighed = first;
      known = true;
    } else {
      const SteepWeights weights{profile, away, fall * (1.0f / kGroup), square};
      SumLines<kRings>(weights, ring, rows, first, group);
      known = false;
    }
    from = to;
    square = next_square;
  }
}

void SpreadDownCurve(const LineGrid& grid, const LineRing& ring, std::span<const LineRows> rows) {
  switch (rows.size()) {
    case 1:
      return DownCurve<1>(grid, ring, rows.data());
    case 2:
      return DownCurve<2>(grid, ring, rows.data());
    default:
      return DownCurve<3>(grid, ring, rows.data());
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
void spread_down_curve(const LineGrid& grid, const LineRing& ring, std::span<const LineRows> rows) {
  HWY_DYNAMIC_DISPATCH(SpreadDownCurve)(grid, ring, rows);
}

}  // namespace kinescope
#endif  // HWY_ONCE
