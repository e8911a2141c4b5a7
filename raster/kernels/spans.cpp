#include "raster/kernels/spans.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/spans.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/sample_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Columns [lo, hi) of each row of a rectangle, both counted from its left side, for each sample:
/// at [row * samples + sample].
template <int kSamples>
struct RowEnds {
  using Ends = std::array<std::int32_t, TileGrid::kMaxTile * kSamples + 8>;
  alignas(64) Ends lo;
  alignas(64) Ends hi;
};

/// An edge over a rectangle: at column k of row r its sign is that of step_x k + step_y r + start,
/// each sample with a start of its own. Dividing by 256 (rounding down) keeps the sign, and pixels
/// lie 256 raw units apart, so the steps stay whole. An edge that crosses a rectangle of at most
/// 64x64 pixels fits 32 bits: steps are at most 2^24, and less than 63+63+2 of them part any two
/// values at samples of the rectangle.
template <int kSamples>
struct RectEdge {
  std::int32_t step_x, step_y;
  std::array<std::int32_t, kSamples> start;
};

/// A value of each sample in its lanes.
template <class Lanes>
HWY_INLINE VI in_lanes(const std::int32_t* of_samples, const Lanes& lanes) {
  const I i;
  if constexpr (Lanes::kSamples == 1) {
    return hn::Set(i, of_samples[0]);
  } else if constexpr (Lanes::kSamples < Lanes::kLanes) {
    static_assert(Lanes::kSamples == 4);
    return hn::LoadDup128(i, of_samples);
  } else {
    return hn::LoadU(i, of_samples + lanes.part * Lanes::kLanes);
  }
}

/// Narrows the rows to the inner side of an edge. Ends come from a float crossing, right to within
/// one pixel, and are then corrected by the exact test.
template <class Lanes>
HWY_INLINE void narrow(const RectEdge<Lanes::kSamples>& edge, const Lanes& lanes, int width,
                       int height, RowEnds<Lanes::kSamples>& ends) {
  const F f;
  const I i;
  const auto one = hn::Set(i, 1);
  const auto zero = hn::Zero(i);
  const std::int32_t rate = edge.step_x < 0 ? -edge.step_x : edge.step_x;
  const auto step = hn::Set(i, rate);
  const auto step_less_1 = hn::Set(i, rate - 1);
  const auto inverse = hn::Set(f, rate == 0 ? 0.0f : 1.0f / static_cast<float>(rate));
  const auto start = in_lanes(edge.start.data(), lanes), step_y = hn::Set(i, edge.step_y);
  for (int r = 0; r < height; r += Lanes::kPixels) {
    const int at = r * Lanes::kSamples + lanes.part * Lanes::kLanes;
    // Lanes that elsewhere are columns here are rows.
    const auto row = hn::Add(lanes.column, hn::Set(i, r));
    const auto value = hn::Add(start, hn::Mul(row, step_y));
    const auto lo = hn::Load(i, ends.lo.data() + at);
    const auto hi = hn::Load(i, ends.hi.data() + at);
    if (edge.step_x > 0) {
      const auto crossing = hn::Ceil(hn::Mul(hn::Neg(hn::ConvertTo(f, value)), inverse));
      const auto clamped =
          hn::Min(hn::Max(crossing, hn::Zero(f)), hn::Set(f, static_cast<float>(width)));
      auto k = hn::ConvertTo(i, clamped);
      const auto at_k = hn::Add(value, hn::Mul(k, step));
      const auto one_more = hn::IfThenElseZero(hn::Lt(at_k, zero), one);
      const auto one_less =
          hn::IfThenElseZero(hn::And(hn::Gt(at_k, step_less_1), hn::Gt(k, zero)), one);
      k = hn::Sub(hn::Add(k, one_more), one_less);
      hn::Store(hn::Max(lo, k), i, ends.lo.data() + at);
    } else if (edge.step_x < 0) {
      const auto crossing = hn::Floor(hn::Mul(hn::ConvertTo(f, value), inverse));
      const auto clamped =
          hn::Min(hn::Max(crossing, hn::Set(f, -1.0f)), hn::Set(f, static_cast<float>(width - 1)));
      auto k = hn::ConvertTo(i, clamped);
      const auto at_k = hn::Sub(value, hn::Mul(k, step));
      const auto one_less = hn::IfThenElseZero(hn::Lt(at_k, zero), one);
      const auto one_more = hn::IfThenElseZero(hn::Gt(at_k, step_less_1), one);
      k = hn::Sub(hn::Add(k, one_more), one_less);
      hn::Store(hn::Min(hi, hn::Add(k, one)), i, ends.hi.data() + at);
    } else {
      hn::Store(hn::IfThenElse(hn::Lt(value, zero), zero, hi), i, ends.hi.data() + at);
    }
  }
}

enum class Cover { kNone, kPart, kAll };

/// Sets the rows' ends, unless nothing is covered; says how much of the rectangle is.
template <int kSamples>
HWY_INLINE Cover find_ends(const TriangleRecord& t, const PixelRect& rect,
                           std::span<const SampleOffset> pattern, RowEnds<kSamples>& ends) {
  using Lanes = SampleLanes<kSamples>;
  const I i;
  const int width = rect.x1 - rect.x0, height = rect.y1 - rect.y0;
  std::array<RectEdge<kSamples>, 3> crossing;
  std::size_t crossings = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = a == 2 ? 0 : a + 1;
    const std::int32_t dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t along_x = -std::int64_t{dy} * (width - 1);
    const std::int64_t along_y = std::int64_t{dx} * (height - 1);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::int64_t most = std::numeric_limits<std::int64_t>::min();
    RectEdge<kSamples>& edge = crossing[crossings];
    for (std::size_t s = 0; s < kSamples; ++s) {
      const std::int64_t px = std::int64_t{rect.x0} * 256 + pattern[s].x.raw();
      const std::int64_t py = std::int64_t{rect.y0} * 256 + pattern[s].y.raw();
      const std::int64_t e = dx * (py - t.y[a]) - dy * (px - t.x[a]) - (top_left ? 0 : 1);
      const std::int64_t start = e >> 8;
      least = std::min(least, start);
      most = std::max(most, start);
      edge.start[s] = static_cast<std::int32_t>(start);  // used only if it fits
    }
    least += std::min<std::int64_t>(along_x, 0) + std::min<std::int64_t>(along_y, 0);
    most += std::max<std::int64_t>(along_x, 0) + std::max<std::int64_t>(along_y, 0);
    if (most < 0) return Cover::kNone;
    if (least >= 0) continue;
    edge.step_x = -dy;
    edge.step_y = dx;
    ++crossings;
  }
  for (int n = 0; n < height * kSamples; n += Lanes::kLanes) {
    hn::Store(hn::Zero(i), i, ends.lo.data() + n);
    hn::Store(hn::Set(i, width), i, ends.hi.data() + n);
  }
  for (int part = 0; part < Lanes::kParts; ++part) {
    const Lanes lanes(pattern, part);
    for (std::size_t e = 0; e < crossings; ++e) narrow(crossing[e], lanes, width, height, ends);
  }
  return crossings == 0 ? Cover::kAll : Cover::kPart;
}

/// Depth-tests and writes one row of a record.
/// @param lo,hi  its samples' ends, counted from column x0
template <class Lanes>
HWY_INLINE void draw_row(const TriangleRecord& t, const std::int32_t* lo, const std::int32_t* hi,
                         int x0, const Lanes& lanes, int y, TileBuffer& tile) {
  int least = lo[0], most = hi[0];
  for (int s = 1; s < Lanes::kSamples; ++s) {
    least = std::min(least, lo[s]);
    most = std::max(most, hi[s]);
  }
  if (least >= most) return;
  const F f;
  const I i;
  const U u;
  const VF nearest = hn::Set(f, t.nearest), farthest = hn::Set(f, t.farthest);
  const VF anchor_x = hn::Set(f, Fixed24_8::from_raw(t.x[0]).to_float());
  const VF anchor_y = hn::Set(f, Fixed24_8::from_raw(t.y[0]).to_float());
  const VF slope = hn::Set(f, t.dz_dx);
  const VF py = hn::Add(hn::Set(f, static_cast<float>(y)), lanes.y_px);
  const VF row = hn::Add(hn::Set(f, t.z), hn::Mul(hn::Set(f, t.dz_dy), hn::Sub(py, anchor_y)));
  const VU ids = hn::Set(u, t.id);
  const VI before = hn::Add(in_lanes(lo, lanes), hn::Set(i, x0 - 1));
  const VI end = hn::Add(in_lanes(hi, lanes), hn::Set(i, x0));
  const int first = (x0 + least) & -Lanes::kPixels;
  float* depth = tile.depth.data() + lanes.place(tile, first, y);
  std::uint32_t* id = tile.id.data() + lanes.place(tile, first, y);
  constexpr int kStep = Lanes::kPixels * Lanes::kSamples;
  for (int x = first; x < x0 + most; x += Lanes::kPixels, depth += kStep, id += kStep) {
    const VI column = hn::Add(hn::Set(i, x), lanes.column);
    const VF px = hn::Add(hn::ConvertTo(f, column), lanes.x_px);
    const VF plane = hn::Add(row, hn::Mul(slope, hn::Sub(px, anchor_x)));
    const VF z = hn::Min(hn::Max(plane, nearest), farthest);
    const VF old_z = hn::Load(f, depth);
    const VU old_id = hn::Load(u, id);
    const auto inside = hn::And(hn::Gt(column, before), hn::Lt(column, end));
    const auto earlier = hn::RebindMask(f, hn::Lt(ids, old_id));
    const auto wins = hn::And(hn::RebindMask(f, inside),
                              hn::Or(hn::Lt(z, old_z), hn::And(hn::Eq(z, old_z), earlier)));
    hn::Store(hn::IfThenElse(wins, z, old_z), f, depth);
    hn::Store(hn::IfThenElse(hn::RebindMask(u, wins), ids, old_id), u, id);
  }
}

/// Bounds on the depth of all samples in a rectangle. DepthPlane::at only multiplies by a constant,
/// adds and clamps, each rounded: so it never falls where the exact plane rises, and its extremes
/// are at corners.
struct DepthRange {
  float nearest, farthest;
};

HWY_INLINE DepthRange depth_range(const TriangleRecord& t, const PixelRect& rect) {
  const DepthPlane plane = {Fixed24_8::from_raw(t.x[0]).to_float(),
                            Fixed24_8::from_raw(t.y[0]).to_float(),
                            t.z,
                            t.dz_dx,
                            t.dz_dy,
                            t.nearest,
                            t.farthest};
  float left = static_cast<float>(rect.x0), right = static_cast<float>(rect.x1);
  float top = static_cast<float>(rect.y0), bottom = static_cast<float>(rect.y1);
  if (t.dz_dx < 0) std::swap(left, right);
  if (t.dz_dy < 0) std::swap(top, bottom);
  return {plane.at(left, top), plane.at(right, bottom)};
}

template <int kSamples>
HWY_INLINE void draw_all(std::span<const TriangleRecord* const> records,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  RowEnds<kSamples> ends;
  for (const TriangleRecord* const record : records) {
    const TriangleRecord& t = *record;
    const PixelRect rect = {std::max<int>(t.x0, tile.rect.x0), std::max<int>(t.y0, tile.rect.y0),
                            std::min<int>(t.x1, tile.rect.x1), std::min<int>(t.y1, tile.rect.y1)};
    const DepthRange range = depth_range(t, rect);
    if (range.nearest > tile.farthest) continue;
    const Cover cover = find_ends(t, rect, pattern, ends);
    if (cover == Cover::kNone) continue;
    for (int part = 0; part < Lanes::kParts; ++part) {
      const Lanes lanes(pattern, part);
      for (int y = rect.y0; y < rect.y1; ++y) {
        const int row = (y - rect.y0) * kSamples;
        draw_row(t, ends.lo.data() + row, ends.hi.data() + row, rect.x0, lanes, y, tile);
      }
    }
    if (cover == Cover::kAll && rect == tile.rect) {
      tile.farthest = std::min(tile.farthest, range.farthest);
    }
  }
}

void DrawRecords(std::span<const TriangleRecord* const> records,
                 std::span<const SampleOffset> pattern, TileBuffer& tile) {
  switch (pattern.size()) {
    case 1:
      return draw_all<1>(records, pattern, tile);
    case 4:
      return draw_all<4>(records, pattern, tile);
    default:
      return draw_all<8>(records, pattern, tile);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawRecords);

void draw_records(std::span<const TriangleRecord* const> records,
                  std::span<const SampleOffset> pattern, TileBuffer& tile) {
  HWY_DYNAMIC_DISPATCH(DrawRecords)(records, pattern, tile);
}

}  // namespace kinescope
#endif
