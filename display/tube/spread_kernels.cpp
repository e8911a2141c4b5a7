#include "display/tube/spread_kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube/spread_kernels.cpp"
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

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(SpreadAcross);
HWY_EXPORT(SpreadDown);

void spread_across(const AcrossTable& table, CellRows cells, SpreadRows out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcross)(table, cells, out);
}
void spread_down(int groups, int taps, const float* const* narrow_rows,
                 const float* const* wide_rows, const float* narrow_weight,
                 const float* wide_weight, bool add, float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadDown)
  (groups, taps, narrow_rows, wide_rows, narrow_weight, wide_weight, add, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
