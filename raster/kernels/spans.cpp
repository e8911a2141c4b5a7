#include "raster/kernels/spans.h"

#include <algorithm>
#include <array>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/spans.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/sample_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Columns [lo, hi) of each row of a rectangle, both counted from its left side.
struct RowEnds {
  alignas(64) std::array<std::int32_t, TileGrid::kMaxTile + 8> lo;
  alignas(64) std::array<std::int32_t, TileGrid::kMaxTile + 8> hi;
};

/// An edge over a rectangle: at column k of row r its sign is that of step_x k + step_y r + start.
/// Dividing by 256 (rounding down) keeps the sign, and pixels lie 256 raw units apart, so the steps
/// stay whole. An edge that crosses a rectangle of at most 64x64 pixels fits 32 bits: steps are at
/// most 2^24 and 63+64 of them part any two values.
struct RectEdge {
  std::int32_t step_x, step_y, start;
};

/// Narrows the rows to the inner side of an edge. Ends come from a float crossing, right to within
/// one pixel, and are then corrected by the exact test.
HWY_INLINE void narrow(const RectEdge& edge, int width, int height, RowEnds& ends) {
  const F f;
  const I i;
  const int lanes = static_cast<int>(hn::Lanes(i));
  const auto one = hn::Set(i, 1);
  const auto zero = hn::Zero(i);
  const std::int32_t rate = edge.step_x < 0 ? -edge.step_x : edge.step_x;
  const auto step = hn::Set(i, rate);
  const auto step_less_1 = hn::Set(i, rate - 1);
  const auto inverse = hn::Set(f, rate == 0 ? 0.0f : 1.0f / static_cast<float>(rate));
  for (int r = 0; r < height; r += lanes) {
    const auto row = hn::Add(hn::Iota(i, 0), hn::Set(i, r));
    const auto value = hn::Add(hn::Set(i, edge.start), hn::Mul(row, hn::Set(i, edge.step_y)));
    const auto lo = hn::Load(i, ends.lo.data() + r);
    const auto hi = hn::Load(i, ends.hi.data() + r);
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
      hn::Store(hn::Max(lo, k), i, ends.lo.data() + r);
    } else if (edge.step_x < 0) {
      const auto crossing = hn::Floor(hn::Mul(hn::ConvertTo(f, value), inverse));
      const auto clamped =
          hn::Min(hn::Max(crossing, hn::Set(f, -1.0f)), hn::Set(f, static_cast<float>(width - 1)));
      auto k = hn::ConvertTo(i, clamped);
      const auto at_k = hn::Sub(value, hn::Mul(k, step));
      const auto one_less = hn::IfThenElseZero(hn::Lt(at_k, zero), one);
      const auto one_more = hn::IfThenElseZero(hn::Gt(at_k, step_less_1), one);
      k = hn::Sub(hn::Add(k, one_more), one_less);
      hn::Store(hn::Min(hi, hn::Add(k, one)), i, ends.hi.data() + r);
    } else {
      hn::Store(hn::IfThenElse(hn::Lt(value, zero), zero, hi), i, ends.hi.data() + r);
    }
  }
}

enum class Cover { kNone, kPart, kAll };

/// Sets the rows' ends for one sample; says how much of the rectangle is covered. Where nothing is,
/// the ends stay as they were.
HWY_INLINE Cover find_ends(const TriangleRecord& t, const PixelRect& rect, SampleOffset sample,
                           RowEnds& ends) {
  const I i;
  const int width = rect.x1 - rect.x0, height = rect.y1 - rect.y0;
  const std::int64_t px = std::int64_t{rect.x0} * 256 + sample.x.raw();
  const std::int64_t py = std::int64_t{rect.y0} * 256 + sample.y.raw();
  std::array<RectEdge, 3> crossing;
  int crossings = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = a == 2 ? 0 : a + 1;
    const std::int32_t dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t e = dx * (py - t.y[a]) - dy * (px - t.x[a]) - (top_left ? 0 : 1);
    const std::int64_t start = e >> 8;
    const std::int64_t along_x = -std::int64_t{dy} * (width - 1);
    const std::int64_t along_y = std::int64_t{dx} * (height - 1);
    const std::int64_t least =
        start + std::min<std::int64_t>(along_x, 0) + std::min<std::int64_t>(along_y, 0);
    const std::int64_t most =
        start + std::max<std::int64_t>(along_x, 0) + std::max<std::int64_t>(along_y, 0);
    if (most < 0) return Cover::kNone;
    if (least >= 0) continue;
    crossing[static_cast<std::size_t>(crossings++)] = {-dy, dx, static_cast<std::int32_t>(start)};
  }
  const int lanes = static_cast<int>(hn::Lanes(i));
  for (int r = 0; r < height; r += lanes) {
    hn::Store(hn::Zero(i), i, ends.lo.data() + r);
    hn::Store(hn::Set(i, width), i, ends.hi.data() + r);
  }
  for (int e = 0; e < crossings; ++e) {
    narrow(crossing[static_cast<std::size_t>(e)], width, height, ends);
  }
  return crossings == 0 ? Cover::kAll : Cover::kPart;
}

/// The ends of one row, in the lanes' own samples.
struct LaneEnds {
  alignas(64) std::array<std::int32_t, 8> lo, hi;  // columns of the screen
  int least, most;                                 // of all lanes
};

template <class Lanes>
HWY_INLINE LaneEnds lane_ends(const std::array<RowEnds, Lanes::kSamples>& ends, std::size_t row,
                              int part, int x0) {
  LaneEnds out;
  out.least = TileGrid::kMaxTile;
  out.most = 0;
  constexpr int kUsed = std::min(Lanes::kSamples, Lanes::kLanes);
  for (int lane = 0; lane < Lanes::kLanes; ++lane) {
    const auto at = static_cast<std::size_t>(lane);
    const RowEnds& of = ends[static_cast<std::size_t>(part * kUsed + lane % kUsed)];
    out.lo[at] = x0 + of.lo[row];
    out.hi[at] = x0 + of.hi[row];
    if (lane >= kUsed || of.lo[row] >= of.hi[row]) continue;
    out.least = std::min(out.least, of.lo[row]);
    out.most = std::max(out.most, of.hi[row]);
  }
  out.least += x0;
  out.most += x0;
  return out;
}

/// Depth-tests and writes one row of a record.
template <class Lanes>
HWY_INLINE void draw_row(const TriangleRecord& t, const LaneEnds& ends, const Lanes& lanes, int y,
                         TileBuffer& tile) {
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
  const VI before = hn::Sub(hn::Load(i, ends.lo.data()), hn::Set(i, 1));
  const VI end = hn::Load(i, ends.hi.data());
  const int first = ends.least & -Lanes::kPixels;
  float* depth = tile.depth.data() + lanes.place(tile, first, y);
  std::uint32_t* id = tile.id.data() + lanes.place(tile, first, y);
  constexpr int kStep = Lanes::kPixels * Lanes::kSamples;
  for (int x = first; x < ends.most; x += Lanes::kPixels, depth += kStep, id += kStep) {
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

/// The ends of each sample's rows. Cover of all samples together.
template <std::size_t kSamples>
HWY_INLINE Cover find_all_ends(const TriangleRecord& t, const PixelRect& rect,
                               std::span<const SampleOffset> pattern,
                               std::array<RowEnds, kSamples>& ends) {
  std::size_t none = 0, all = 0;
  for (std::size_t s = 0; s < kSamples; ++s) {
    const Cover cover = find_ends(t, rect, pattern[s], ends[s]);
    if (cover == Cover::kNone && kSamples > 1) ends[s].hi = ends[s].lo = {};
    none += cover == Cover::kNone ? 1 : 0;
    all += cover == Cover::kAll ? 1 : 0;
  }
  return none == kSamples ? Cover::kNone : all == kSamples ? Cover::kAll : Cover::kPart;
}

template <int kSamples>
HWY_INLINE void draw_all(std::span<const TriangleRecord* const> records,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  std::array<RowEnds, kSamples> ends;
  for (const TriangleRecord* const record : records) {
    const TriangleRecord& t = *record;
    const PixelRect rect = {std::max<int>(t.x0, tile.rect.x0), std::max<int>(t.y0, tile.rect.y0),
                            std::min<int>(t.x1, tile.rect.x1), std::min<int>(t.y1, tile.rect.y1)};
    const DepthRange range = depth_range(t, rect);
    if (range.nearest > tile.farthest) continue;
    const Cover cover = find_all_ends(t, rect, pattern, ends);
    if (cover == Cover::kNone) continue;
    for (int part = 0; part < Lanes::kParts; ++part) {
      const Lanes lanes(pattern, part);
      for (int y = rect.y0; y < rect.y1; ++y) {
        const auto row = static_cast<std::size_t>(y - rect.y0);
        draw_row(t, lane_ends<Lanes>(ends, row, part, rect.x0), lanes, y, tile);
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
