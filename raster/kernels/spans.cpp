#include "raster/kernels/spans.h"

#include <algorithm>
#include <array>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/spans.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;

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

/// Sets the rows' ends for one sample; says how much of the rectangle is covered.
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

/// Depth-tests and writes one span: columns [x0, x1) of the screen.
HWY_INLINE void draw_span(const TriangleRecord& t, float row_z, float anchor_x, float sample_x,
                          int x0, int x1, float* depth, std::uint32_t* id, int tile_x) {
  const F f;
  const I i;
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const auto nearest = hn::Set(f, t.nearest), farthest = hn::Set(f, t.farthest);
  const auto slope = hn::Set(f, t.dz_dx), row = hn::Set(f, row_z), anchor = hn::Set(f, anchor_x);
  const auto ids = hn::Set(u, t.id);
  const auto first = hn::Set(i, x0 - 1), end = hn::Set(i, x1);
  for (int x = x0 & -lanes; x < x1; x += lanes) {
    const auto column = hn::Iota(i, x);
    const auto centre = hn::Add(hn::ConvertTo(f, column), hn::Set(f, sample_x));
    const auto plane = hn::Add(row, hn::Mul(slope, hn::Sub(centre, anchor)));
    const auto z = hn::Min(hn::Max(plane, nearest), farthest);
    float* const old_z_at = depth + (x - tile_x);
    std::uint32_t* const old_id_at = id + (x - tile_x);
    const auto old_z = hn::Load(f, old_z_at);
    const auto old_id = hn::Load(u, old_id_at);
    const auto inside = hn::And(hn::Gt(column, first), hn::Lt(column, end));
    const auto earlier = hn::RebindMask(f, hn::Lt(ids, old_id));
    const auto wins = hn::And(hn::RebindMask(f, inside),
                              hn::Or(hn::Lt(z, old_z), hn::And(hn::Eq(z, old_z), earlier)));
    hn::Store(hn::IfThenElse(wins, z, old_z), f, old_z_at);
    hn::Store(hn::IfThenElse(hn::RebindMask(u, wins), ids, old_id), u, old_id_at);
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

void DrawRecords(std::span<const TriangleRecord* const> records,
                 std::span<const SampleOffset> pattern, TileBuffer& tile) {
  RowEnds ends;
  for (const TriangleRecord* const record : records) {
    const TriangleRecord& t = *record;
    const PixelRect rect = {std::max<int>(t.x0, tile.rect.x0), std::max<int>(t.y0, tile.rect.y0),
                            std::min<int>(t.x1, tile.rect.x1), std::min<int>(t.y1, tile.rect.y1)};
    const DepthRange range = depth_range(t, rect);
    if (range.nearest > tile.farthest) continue;
    bool covers_tile = rect == tile.rect;
    const float anchor_x = Fixed24_8::from_raw(t.x[0]).to_float();
    const float anchor_y = Fixed24_8::from_raw(t.y[0]).to_float();
    for (std::size_t s = 0; s < pattern.size(); ++s) {
      const Cover cover = find_ends(t, rect, pattern[s], ends);
      covers_tile = covers_tile && cover == Cover::kAll;
      if (cover == Cover::kNone) continue;
      const float sample_x = pattern[s].x.to_float(), sample_y = pattern[s].y.to_float();
      for (int y = rect.y0; y < rect.y1; ++y) {
        const auto r = static_cast<std::size_t>(y - rect.y0);
        if (ends.lo[r] >= ends.hi[r]) continue;
        const float row_z = t.z + t.dz_dy * (static_cast<float>(y) + sample_y - anchor_y);
        const auto at = s * static_cast<std::size_t>(tile.plane) +
                        static_cast<std::size_t>((y - tile.rect.y0) * tile.stride);
        draw_span(t, row_z, anchor_x, sample_x, rect.x0 + ends.lo[r], rect.x0 + ends.hi[r],
                  tile.depth.data() + at, tile.id.data() + at, tile.rect.x0);
      }
    }
    if (covers_tile) tile.farthest = std::min(tile.farthest, range.farthest);
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
