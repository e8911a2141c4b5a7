// The exact area of stroked segments, several pixels or edges at a time, exactly as
// stroke_coverage.h finds it.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_PATH_STROKE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_PATH_STROKE_LANES_INL_H_
#undef KINESCOPE_RASTER_PATH_STROKE_LANES_INL_H_
#else
#define KINESCOPE_RASTER_PATH_STROKE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "raster/path/ink-inl.h"
#include "raster/path/stroke.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Ramp::at() in lanes.
class RampLanes {
 public:
  HWY_INLINE explicit RampLanes(const Ramp& ramp)
      : RampLanes(ramp.flat, ramp.rate, ramp.bend, ramp.inv_bend, ramp.start) {}
  HWY_INLINE RampLanes(float flat, float rate, float bend, float inv_bend, float start)
      : flat_(hn::Set(CoverTag(), flat)),
        rate_(hn::Set(CoverTag(), rate)),
        bend_(hn::Set(CoverTag(), bend)),
        inv_bend_(hn::Set(CoverTag(), inv_bend)),
        start_(hn::Set(CoverTag(), start)) {}

  HWY_INLINE Cover at(Cover distance) const {
    const CoverTag f;
    const Cover t = hn::Abs(distance);
    const Cover rest =
        hn::Min(hn::Max(hn::Sub(start_, hn::Mul(t, inv_bend_)), hn::Zero(f)), hn::Set(f, 1.0f));
    const Cover curved = hn::Sub(bend_, hn::Mul(bend_, hn::Mul(rest, rest)));
    return hn::CopySign(hn::Add(hn::Mul(hn::Min(t, flat_), rate_), curved), distance);
  }

 private:
  Cover flat_, rate_, bend_, inv_bend_, start_;
};

HWY_INLINE Cover unit(Cover c) {
  return hn::Min(hn::Max(c, hn::Zero(CoverTag())), hn::Set(CoverTag(), 1.0f));
}

/// Edges of an outline within one row, ready for lanes.
struct RowEdges {
  static constexpr std::size_t kCount = OutlineEdges::kCount;
  using D = hn::CappedTag<double, kCount>;
  using F = hn::Rebind<float, D>;
  static constexpr double kNowhere = 1e300;

  alignas(32) std::array<double, kCount> left, right, middle;
  alignas(16) std::array<float, kCount> run, weight, first, flat, rate, bend, inv_bend, start;

  /// edge_in_row() for all four; left and right of what is not there is nowhere.
  HWY_INLINE void find(const OutlineEdges& edges, int y) {
    const D d;
    const F f;
    const auto row = hn::Set(d, static_cast<double>(y));
    const auto next = hn::Add(row, hn::Set(d, 1.0));
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto top = hn::LoadU(d, edges.top.data() + i);
      const auto x = hn::LoadU(d, edges.x.data() + i);
      const auto slope = hn::LoadU(d, edges.slope.data() + i);
      const auto from = hn::Max(top, row);
      const auto to = hn::Min(hn::LoadU(d, edges.bottom.data() + i), next);
      const auto x0 = hn::Add(x, hn::Mul(hn::Sub(from, top), slope));
      const auto x1 = hn::Add(x, hn::Mul(hn::Sub(to, top), slope));
      const auto low = hn::Min(x0, x1), high = hn::Max(x0, x1);
      const auto there = hn::Gt(to, from);
      const auto height = hn::DemoteTo(f, hn::IfThenElseZero(there, hn::Sub(to, from)));
      hn::Store(hn::IfThenElse(there, low, hn::Set(d, kNowhere)), d, left.data() + i);
      hn::Store(hn::IfThenElse(there, high, hn::Set(d, -kNowhere)), d, right.data() + i);
      hn::Store(hn::Mul(hn::Set(d, 0.5), hn::Add(x0, x1)), d, middle.data() + i);
      hn::StoreU(hn::DemoteTo(f, hn::Sub(high, low)), f, run.data() + i);
      hn::StoreU(hn::Mul(height, hn::LoadU(f, edges.sign.data() + i)), f, weight.data() + i);
    }
  }

  HWY_INLINE double leftmost() const {
    return std::min(std::min(left[0], left[1]), std::min(left[2], left[3]));
  }
  HWY_INLINE double rightmost() const {
    return std::max(std::max(right[0], right[1]), std::max(right[2], right[3]));
  }

  /// Makes the ramps, and the distances from the middles to pixel x's.
  HWY_INLINE void set_ramps(int x) {
    const D d;
    const F f;
    const auto pixel = hn::Set(d, x + 0.5);
    const auto one = hn::Set(f, 1.0f), half = hn::Set(f, 0.5f);
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto distance = hn::Sub(pixel, hn::Load(d, middle.data() + i));
      const auto r = hn::LoadU(f, run.data() + i);
      const auto longer = hn::Max(r, one);
      const auto shorter = hn::Max(hn::Min(r, one), hn::Set(f, 1e-6f));
      const auto per_pixel = hn::Div(one, longer), inverse = hn::Div(one, shorter);
      const auto ends = hn::Mul(half, hn::Add(longer, shorter));
      hn::StoreU(hn::DemoteTo(f, distance), f, first.data() + i);
      hn::StoreU(hn::Mul(half, hn::Sub(longer, shorter)), f, flat.data() + i);
      hn::StoreU(per_pixel, f, rate.data() + i);
      hn::StoreU(hn::Mul(hn::Mul(half, shorter), per_pixel), f, bend.data() + i);
      hn::StoreU(inverse, f, inv_bend.data() + i);
      hn::StoreU(hn::Mul(ends, inverse), f, start.data() + i);
    }
  }

  /// What edge i adds to pixels that lie `step` right of the first.
  HWY_INLINE Cover share(std::size_t i, Cover step) const {
    const CoverTag f;
    const RampLanes ramp(flat[i], rate[i], bend[i], inv_bend[i], start[i]);
    const Cover right_of = ramp.at(hn::Add(hn::Set(f, first[i]), step));
    return hn::Mul(hn::Set(f, weight[i]), hn::Add(hn::Set(f, 0.5f), right_of));
  }
};

/// Where the sides lie in several rows: the first pixel touched and the one after the last, and the
/// distances to the first one's middle from the middles of both.
struct BodyRows {
  static constexpr int kCount = 4;
  alignas(32) std::array<std::int32_t, kCount> first, last;
  alignas(32) std::array<float, kCount> from_left, from_right;

  HWY_INLINE void find(const StrokeOutline& o, int y, int x_end) {
    const hn::CappedTag<double, kCount> d;
    const hn::Rebind<float, decltype(d)> f;
    const hn::Rebind<std::int32_t, decltype(d)> i32;
    const auto half = hn::Set(d, 0.5);
    const auto reach = hn::Set(d, 0.5 * std::abs(o.slope));
    const auto across = hn::Set(d, o.across), zero = hn::Zero(d);
    const auto width = hn::Set(d, static_cast<double>(x_end));
    const auto within = [&](auto x) { return hn::Min(hn::Max(x, zero), width); };
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto row = hn::Iota(d, static_cast<double>(y + static_cast<int>(i)));
      const auto down = hn::Sub(hn::Add(row, half), hn::Set(d, o.left_y));
      const auto middle = hn::Add(hn::Set(d, o.left_x), hn::Mul(hn::Set(d, o.slope), down));
      const auto x = within(hn::Floor(hn::Sub(middle, reach)));
      const auto end = within(hn::Ceil(hn::Add(hn::Add(middle, across), reach)));
      const auto left = hn::Sub(hn::Add(x, half), middle);
      hn::StoreU(hn::DemoteTo(i32, x), i32, first.data() + i);
      hn::StoreU(hn::DemoteTo(i32, end), i32, last.data() + i);
      hn::StoreU(hn::DemoteTo(f, left), f, from_left.data() + i);
      hn::StoreU(hn::DemoteTo(f, hn::Sub(left, across)), f, from_right.data() + i);
    }
  }
};

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // include guard
