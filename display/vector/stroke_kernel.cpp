#include "display/vector/stroke_kernel.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "display/vector/stroke_law.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/vector/stroke_kernel.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "display/eight_floats-inl.h"
#include "display/vector/beam_spots-inl.h"
#include "display/vector/beam_target-inl.h"
#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// 2^x for x in [-126, 126], to 2e-7, by its power series. Adding 1.5 * 2^23 leaves the whole part
/// in the lowest bits.
HWY_INLINE Floats exp2_of(Floats x) {
  const Floats shifter = set(12582912.0f);
  const Floats shifted = hn::Add(x, shifter);
  const Floats f = hn::Sub(x, hn::Sub(shifted, shifter));
  Floats p = hn::MulAdd(set(0.00015403530f), f, set(0.0013333558f));
  p = hn::MulAdd(p, f, set(0.0096181291f));
  p = hn::MulAdd(p, f, set(0.055504109f));
  p = hn::MulAdd(p, f, set(0.24022651f));
  p = hn::MulAdd(p, f, set(0.69314718f));
  p = hn::MulAdd(p, f, set(1.0f));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
}

/// Rows [first, last) of a column of pixels.
struct Rows {
  float first = 0, last = kBeamTile;

  /// Keeps rows y at which start + y / per_row lies between `least` and `most`. `per_row` is 0
  /// where it does not change.
  HWY_INLINE void keep(float start, float per_row, float least, float most) {
    if (per_row == 0) {
      if (start < least || start > most) last = 0;
      return;
    }
    const float a = (least - start) * per_row, b = (most - start) * per_row;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b) + 1);
  }
  HWY_INLINE int begin() const { return static_cast<int>(std::ceil(first)); }
  HWY_INLINE int end() const { return static_cast<int>(std::max(last, 0.0f)); }
};

/// How much of a line's whole height there is along it.
enum class Ends { kNone, kNearer, kBoth };

template <Ends kEnds>
HWY_INLINE Floats share_along(Floats u, Floats length) {
  if (kEnds == Ends::kNone) return set(1);
  if (kEnds == Ends::kBoth) return hn::Sub(normal_below(u), normal_below(hn::Sub(u, length)));
  // So long that no pixel sees both ends.
  return hn::Add(normal_below(hn::Min(u, hn::Sub(length, u))), set(0.5f));
}

/// A column as wide as a vector, walked down: of the Gaussian across the line each row's is the
/// last one's times a ratio, which itself changes by one factor.
struct Column {
  Floats along, across;  // in the row that comes next, deviations
  Floats height, ratio;
  int at;  // in the tile's plane

  HWY_INLINE Column(const stroke_law::Line& line, int x, int y) : at(y * kBeamTile + x) {
    const Floats right = hn::Add(lane_numbers(d), set(static_cast<float>(x)));
    const auto down = static_cast<float>(y);
    along = hn::MulAdd(right, set(line.along_x), set(line.along_0 + down * line.along_y));
    across = hn::MulAdd(right, set(line.across_x), set(line.across_0 + down * line.across_y));
    // Far from the line a lane starts from next to nothing, but from no denormal number.
    constexpr float kHalfLog2E = 0.72134752f, kMost = 170;
    const Floats q = hn::Min(hn::Mul(across, across), set(kMost));
    height = hn::Mul(exp2_of(hn::Mul(q, set(-kHalfLog2E))), set(line.peak));
    const float step = line.across_y;
    ratio = exp2_of(hn::Mul(hn::MulAdd(across, set(2 * step), set(step * step)), set(-kHalfLog2E)));
  }

  /// Draws some rows. What is stored might alias what is not a copy.
  template <Ends kEnds>
  HWY_INLINE void draw(const stroke_law::Line& line, int rows, hn::Mask<F> inside,
                       const Target& target) {
    if (rows <= 0) return;
    const Floats factor = set(line.ratio_step), fourth = set(line.fourth);
    const Floats length = set(line.length), reach = set(kSpotReach * kSpotReach);
    const Floats along_step = set(line.along_y), across_step = set(line.across_y);
    Floats u = along, v = across, h = height, r = ratio;
    const Target to = target;
    int place = at;
    for (const int end = at + rows * kBeamTile; place < end; place += kBeamTile) {
      const Floats q = hn::Mul(v, v);
      const Floats hermite = hn::MulAdd(hn::Sub(q, set(6)), q, set(3));
      Floats share = hn::Mul(h, hn::NegMulAdd(fourth, hermite, set(1)));
      if (kEnds != Ends::kNone) share = hn::Mul(share, share_along<kEnds>(u, length));
      to.add(place, hn::IfThenElseZero(hn::And(inside, hn::Le(q, reach)), share));
      u = hn::Add(u, along_step);
      v = hn::Add(v, across_step);
      h = hn::Mul(h, r);
      r = hn::Mul(r, factor);
    }
    along = u, across = v, height = h, ratio = r, at = place;
  }
};

/// What the rows of a column are: which the stroke reaches, and which lie wholly between its ends.
struct ColumnRows {
  int begin, end, whole_begin, whole_end;

  HWY_INLINE ColumnRows(const stroke_law::Line& line, float x, float width) {
    const float u = line.along_0 + x * line.along_x, u_step = width * line.along_x;
    const float v = line.across_0 + x * line.across_x, v_step = width * line.across_x;
    const float u_low = std::min(u_step, 0.0f), u_high = std::max(u_step, 0.0f);
    const float v_low = std::min(v_step, 0.0f), v_high = std::max(v_step, 0.0f);
    Rows reached;
    reached.keep(v, line.rows_across, -kSpotReach - v_high, kSpotReach - v_low);
    reached.keep(u, line.rows_along, -kSpotReach - u_high, line.length + kSpotReach - u_low);
    begin = reached.begin(), end = std::max(begin, reached.end());
    Rows whole = reached;
    whole.keep(u, line.rows_along, kSpotReach - u_low, line.length - kSpotReach - u_high);
    whole_begin = std::clamp(whole.begin(), begin, end);
    whole_end = line.length > 2 * kSpotReach + u_high - u_low
                    ? std::clamp(whole.end(), whole_begin, end)
                    : whole_begin;
  }
};

HWY_INLINE void draw_column(const stroke_law::Line& line, int x, int width, const Target& target) {
  const ColumnRows rows(line, static_cast<float>(x), static_cast<float>(width - 1));
  if (rows.begin >= rows.end) return;
  Column column(line, x, rows.begin);
  const auto inside = hn::Lt(lane_numbers(d), set(static_cast<float>(width)));
  // So long that no pixel sees both ends.
  const bool apart = line.length > 2 * kSpotReach;
  const int before = rows.whole_begin - rows.begin, after = rows.end - rows.whole_end;
  if (apart) {
    column.draw<Ends::kNearer>(line, before, inside, target);
    column.draw<Ends::kNone>(line, rows.whole_end - rows.whole_begin, inside, target);
    column.draw<Ends::kNearer>(line, after, inside, target);
  } else {
    column.draw<Ends::kBoth>(line, rows.end - rows.begin, inside, target);
  }
}

HWY_INLINE void draw_line(const BeamStroke& stroke, float length, const Target& target) {
  const BeamTile& tile = target.tile;
  const stroke_law::Line line(stroke, length, static_cast<float>(tile.x),
                              static_cast<float>(tile.y));
  const float left = std::min(stroke.x0, stroke.x1) - line.reach - static_cast<float>(tile.x);
  const float right = std::max(stroke.x0, stroke.x1) + line.reach - static_cast<float>(tile.x);
  const int begin = static_cast<int>(std::max(left - 0.5f, 0.0f));
  const int end = static_cast<int>(std::clamp<float>(right + 0.5f, 0, kBeamTile));
  for (int x = begin; x < end; x += lanes()) {
    draw_column(line, x, std::min(lanes(), end - x), target);
  }
}

/// A part so short that a few spots add up to it. From (x0, y0) to (x1, y1) in the tile.
HWY_INLINE void draw_part(float x0, float y0, float x1, float y1, float sigma, float scale,
                          const Target& target) {
  const auto& rule = stroke_law::quadrature_for(std::hypot(x1 - x0, y1 - y0) / sigma);
  BeamSpots spots;
  spots.count = rule.nodes;
  for (std::size_t k = 0; k < static_cast<std::size_t>(rule.nodes); ++k) {
    const float t = 0.5f + 0.5f * rule.at[k];
    spots.x[k] = x0 + t * (x1 - x0), spots.y[k] = y0 + t * (y1 - y0);
    spots.sigma[k] = sigma, spots.share[k] = rule.weight[k] * scale;
  }
  draw_spots(spots, target);
}

/// The share of a stroke's way, [from, to], that lies within `low` and `high` on one axis.
HWY_INLINE void keep_between(float start, float end, float low, float high, float& from,
                             float& to) {
  const float way = end - start;
  if (std::abs(way) < 1e-9f) {
    if (start < low || start > high) to = from - 1;
    return;
  }
  const float a = (low - start) / way, b = (high - start) / way;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
}

HWY_INLINE void draw_parts(const BeamStroke& s, float length, const Target& target) {
  const float sigma = stroke_law::drawn_sigma(s), reach = kSpotReach * sigma + 1;
  const auto left = static_cast<float>(target.tile.x), top = static_cast<float>(target.tile.y);
  const float x0 = s.x0 - left, y0 = s.y0 - top, x1 = s.x1 - left, y1 = s.y1 - top;
  float from = 0, to = 1;
  keep_between(x0, x1, -reach, kBeamTile + reach, from, to);
  keep_between(y0, y1, -reach, kBeamTile + reach, from, to);
  if (to < from) return;
  const int parts = stroke_law::parts_of(sigma, length);
  const float share = 1.0f / static_cast<float>(parts);
  const int first = std::clamp(static_cast<int>(from / share), 0, parts - 1);
  const int last = std::clamp(static_cast<int>(to / share), 0, parts - 1);
  for (int part = first; part <= last; ++part) {
    const float a = static_cast<float>(part) * share, b = static_cast<float>(part + 1) * share;
    draw_part(x0 + a * (x1 - x0), y0 + a * (y1 - y0), x0 + b * (x1 - x0), y0 + b * (y1 - y0), sigma,
              share, target);
  }
}

HWY_INLINE void draw_stroke(const BeamStroke& stroke, const Target& target) {
  const float length = stroke_law::length_of(stroke);
  if (stroke_law::has_closed_form(stroke.sigma, length)) {
    draw_line(stroke, length, target);
  } else {
    draw_parts(stroke, length, target);
  }
}

HWY_INLINE void draw_spots_on(const BeamSpots& spots, const Target& target) {
  BeamSpots here = spots;
  for (float& x : here.x) x -= static_cast<float>(target.tile.x);
  for (float& y : here.y) y -= static_cast<float>(target.tile.y);
  draw_spots(here, target);
}

void DrawMarks(const BeamMarks& marks, std::span<const std::uint32_t> order, const BeamTile& tile) {
  const auto planes = static_cast<std::size_t>(tile.planes);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t ahead = i + kMarksAhead;
    if (ahead < order.size()) prefetch_mark(marks, order[ahead], planes);
    const std::size_t number = order[i], strokes = marks.strokes.size();
    const bool is_stroke = number < strokes;
    const float* const weights = is_stroke ? &marks.stroke_weights[number * planes]
                                           : &marks.spot_weights[(number - strokes) * planes];
    const LitPlanes lit(tile, weights);
    if (lit.count == 0) continue;
    const Target target{tile, lit};
    if (is_stroke) {
      draw_stroke(marks.strokes[number], target);
    } else {
      draw_spots_on(marks.spots[number - strokes], target);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawMarks);

void prefetch_mark(const BeamMarks& marks, std::size_t number, std::size_t planes) {
  const auto fetch = [](const auto* first, std::size_t count) {
    const auto* const bytes = reinterpret_cast<const std::byte*>(first);
    const std::size_t size = count * sizeof(*first);
    for (std::size_t at = 0; at < size; at += 64) hwy::Prefetch(bytes + at);
    hwy::Prefetch(bytes + size - 1);
  };
  if (number < marks.strokes.size()) {
    fetch(&marks.strokes[number], 1);
    fetch(&marks.stroke_weights[number * planes], planes);
  } else {
    const std::size_t i = number - marks.strokes.size();
    fetch(&marks.spots[i], 1);
    fetch(&marks.spot_weights[i * planes], planes);
  }
}

void draw_marks(const BeamMarks& marks, std::span<const std::uint32_t> order,
                const BeamTile& tile) {
  HWY_DYNAMIC_DISPATCH(DrawMarks)(marks, order, tile);
}

}  // namespace kinescope
#endif  // HWY_ONCE
