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

#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using F = hn::CappedTag<float, 8>;
using Floats = hn::Vec<F>;
constexpr F d;
constexpr hn::RebindToSigned<F> di;

HWY_INLINE int lanes() { return static_cast<int>(hn::Lanes(d)); }
HWY_INLINE Floats set(float v) { return hn::Set(d, v); }

/// exp(-q / 2) for q from 0 to 2 * kSpotReach^2, to 4e-6. Adding 1.5 * 2^23 leaves the whole part
/// in the lowest bits.
HWY_INLINE Floats gaussian(Floats q) {
  const Floats shifter = set(12582912.0f);
  const Floats x = hn::Mul(q, set(-0.72134752f));
  const Floats shifted = hn::Add(x, shifter);
  const Floats f = hn::Sub(x, hn::Sub(shifted, shifter));
  Floats p = hn::MulAdd(set(0.0013266979f), f, set(0.0096754694f));
  p = hn::MulAdd(p, f, set(0.055507427f));
  p = hn::MulAdd(p, f, set(0.24022122f));
  p = hn::MulAdd(p, f, set(0.69314695f));
  p = hn::MulAdd(p, f, set(1.0f));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
}

/// A normal distribution's share below z deviations, less a half; cut at kSpotReach and scaled to
/// reach it: to 8e-6, by a Chebyshev series in z^2.
HWY_INLINE Floats normal_below(Floats z) {
  z = hn::Min(hn::Max(z, set(-kSpotReach)), set(kSpotReach));
  const Floats q = hn::Mul(z, z);
  Floats p = hn::MulAdd(set(9.56817037e-11f), q, set(-8.02693226e-09f));
  p = hn::MulAdd(p, q, set(3.00281915e-07f));
  p = hn::MulAdd(p, q, set(-6.72111987e-06f));
  p = hn::MulAdd(p, q, set(0.00010251739f));
  p = hn::MulAdd(p, q, set(-0.00115129315f));
  p = hn::MulAdd(p, q, set(0.00992215142f));
  p = hn::MulAdd(p, q, set(-0.0664651646f));
  p = hn::MulAdd(p, q, set(0.398964777f));
  return hn::Mul(p, z);
}

/// Pixels [first, last) of a row.
struct Span {
  float first = 0, last = kBeamTile;

  /// Keeps pixels x with `least` <= start + slope * x <= `most`.
  HWY_INLINE void keep(float start, float slope, float least, float most) {
    if (std::abs(slope) < 1e-5f) {
      if (start < least - 1e-3f || start > most + 1e-3f) last = 0;
      return;
    }
    float a = (least - start) / slope, b = (most - start) / slope;
    if (a > b) std::swap(a, b);
    first = std::max(first, a);
    last = std::min(last, b + 1);
  }
};

/// Where a tile's planes are, and what a stroke is worth on each.
struct Target {
  const BeamTile& tile;
  const float* weights;

  HWY_INLINE void add(int at, Floats share) const {
    float* light = tile.light + at;
    for (int p = 0; p < tile.planes; ++p, light += kBeamTilePlane) {
      hn::StoreU(hn::MulAdd(set(weights[p]), share, hn::LoadU(d, light)), d, light);
    }
  }
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

template <Ends kEnds>
HWY_INLINE void line_row(const stroke_law::Line& line, float u0, float v0, int first, int last,
                         int row, const Target& target) {
  const Floats step = lane_numbers(d);
  for (int x = first; x < last; x += lanes()) {
    const Floats at = hn::Add(step, set(static_cast<float>(x)));
    const Floats v = hn::MulAdd(at, set(line.across_x), set(v0));
    const Floats q = hn::Min(hn::Mul(v, v), set(2 * kSpotReach * kSpotReach));
    const Floats hermite = hn::MulAdd(hn::Sub(q, set(6)), q, set(3));
    Floats share = hn::Mul(gaussian(q), hn::NegMulAdd(set(line.fourth), hermite, set(1)));
    if (kEnds != Ends::kNone) {
      const Floats u = hn::MulAdd(at, set(line.along_x), set(u0));
      share = hn::Mul(share, share_along<kEnds>(u, set(line.length)));
    }
    const auto inside = hn::Lt(step, set(static_cast<float>(last - x)));
    target.add(row + x, hn::IfThenElseZero(inside, hn::Mul(share, set(line.peak))));
  }
}

HWY_INLINE void draw_line(const BeamStroke& stroke, float length, const Target& target) {
  const BeamTile& tile = target.tile;
  const stroke_law::Line line(stroke, length, static_cast<float>(tile.x),
                              static_cast<float>(tile.y));
  const bool apart = line.length > 2 * kSpotReach;
  // Rows that the ends' spots reach.
  const float reach = kSpotReach * std::sqrt(stroke.sigma * stroke.sigma + 1.0f / 12);
  const float top = std::min(stroke.y0, stroke.y1) - reach - 0.5f - static_cast<float>(tile.y);
  const float bottom = std::max(stroke.y0, stroke.y1) + reach + 0.5f - static_cast<float>(tile.y);
  const int y_begin = static_cast<int>(std::max(top, 0.0f));
  const int y_end = static_cast<int>(std::min(bottom, static_cast<float>(kBeamTile)));
  for (int y = y_begin; y < y_end; ++y) {
    const float u0 = line.along_0 + static_cast<float>(y) * line.along_y;
    const float v0 = line.across_0 + static_cast<float>(y) * line.across_y;
    Span span;
    span.keep(v0, line.across_x, -kSpotReach, kSpotReach);
    span.keep(u0, line.along_x, -kSpotReach, line.length + kSpotReach);
    const int first = static_cast<int>(std::ceil(std::max(span.first, 0.0f)));
    const int last = static_cast<int>(std::min<float>(span.last, kBeamTile));
    if (last <= first) continue;
    const float u_first = u0 + line.along_x * static_cast<float>(first);
    const float u_last = u0 + line.along_x * static_cast<float>(last);
    const bool whole = std::min(u_first, u_last) > kSpotReach &&
                       std::max(u_first, u_last) < line.length - kSpotReach;
    const int row = y * kBeamTile;
    if (whole) {
      line_row<Ends::kNone>(line, u0, v0, first, last, row, target);
    } else if (apart) {
      line_row<Ends::kNearer>(line, u0, v0, first, last, row, target);
    } else {
      line_row<Ends::kBoth>(line, u0, v0, first, last, row, target);
    }
  }
}

/// Pixels [begin, end) of a tile's axis that spots with their middles in [low, high] reach.
struct Reached {
  int begin, end;
  HWY_INLINE Reached(float low, float high, float reach) {
    constexpr float kTile = kBeamTile;
    begin = static_cast<int>(std::floor(std::clamp(low - reach, 0.0f, kTile)));
    end = static_cast<int>(std::ceil(std::clamp(high + reach, 0.0f, kTile)));
  }
  HWY_INLINE int count() const { return end - begin; }
};

constexpr std::size_t kAxis = kBeamTile + 16;
using Axis = std::array<float, kAxis>;

/// shares[i]: of a spot, on pixel begin + i of an axis.
HWY_INLINE void axis_shares(const Reached& range, float middle, float sigma, float scale,
                            Axis& shares) {
  const Floats per_pixel = set(1 / sigma);
  const int count = range.count();
  for (int i = 0; i < count; i += lanes()) {
    const Floats at = hn::Add(lane_numbers(d), set(static_cast<float>(range.begin + i) - middle));
    const Floats z = hn::Mul(at, per_pixel);
    const Floats below = normal_below(z), next = normal_below(hn::Add(z, per_pixel));
    const auto inside = hn::Lt(lane_numbers(d), set(static_cast<float>(count - i)));
    hn::StoreU(hn::IfThenElseZero(inside, hn::Mul(hn::Sub(next, below), set(scale))), d,
               shares.data() + i);
  }
}

/// A part so short that a few spots add up to it. From (x0, y0) to (x1, y1) in the tile.
HWY_INLINE void draw_part(float x0, float y0, float x1, float y1, float sigma, float scale,
                          const Target& target) {
  const float reach = kSpotReach * sigma;
  const Reached across(std::min(x0, x1), std::max(x0, x1), reach);
  const Reached down(std::min(y0, y1), std::max(y0, y1), reach);
  if (across.count() <= 0 || down.count() <= 0) return;
  const auto& rule = stroke_law::quadrature_for(std::hypot(x1 - x0, y1 - y0) / sigma);
  const auto nodes = static_cast<std::size_t>(rule.nodes);
  std::array<Axis, 4> x_share, y_share;
  for (std::size_t k = 0; k < nodes; ++k) {
    const float t = 0.5f + 0.5f * rule.at[k];
    axis_shares(across, x0 + t * (x1 - x0), sigma, 1, x_share[k]);
    axis_shares(down, y0 + t * (y1 - y0), sigma, rule.weight[k] * scale, y_share[k]);
  }
  for (int y = 0; y < down.count(); ++y) {
    const int row = (down.begin + y) * kBeamTile + across.begin;
    for (int x = 0; x < across.count(); x += lanes()) {
      Floats sum = hn::Zero(d);
      for (std::size_t k = 0; k < nodes; ++k) {
        sum = hn::MulAdd(set(y_share[k][static_cast<std::size_t>(y)]),
                         hn::LoadU(d, x_share[k].data() + x), sum);
      }
      target.add(row + x, sum);
    }
  }
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

/// Strokes lie anywhere in memory.
HWY_INLINE void prefetch(std::span<const BeamStroke> strokes, const float* weights,
                         std::span<const std::uint32_t> order, std::size_t i, int planes) {
  constexpr std::size_t kAhead = 8;
  if (i + kAhead >= order.size()) return;
  const std::size_t next = order[i + kAhead];
  hwy::Prefetch(&strokes[next]);
  hwy::Prefetch(weights + next * static_cast<std::size_t>(planes));
}

void DrawStrokes(std::span<const BeamStroke> strokes, const float* weights,
                 std::span<const std::uint32_t> order, const BeamTile& tile) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    prefetch(strokes, weights, order, i, tile.planes);
    const BeamStroke& stroke = strokes[order[i]];
    const Target target{tile, weights + order[i] * static_cast<std::size_t>(tile.planes)};
    const float length = stroke_law::length_of(stroke);
    if (stroke_law::has_closed_form(stroke.sigma, length)) {
      draw_line(stroke, length, target);
    } else {
      draw_parts(stroke, length, target);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawStrokes);

void draw_strokes(std::span<const BeamStroke> strokes, const float* weights,
                  std::span<const std::uint32_t> order, const BeamTile& tile) {
  HWY_DYNAMIC_DISPATCH(DrawStrokes)(strokes, weights, order, tile);
}

}  // namespace kinescope
#endif  // HWY_ONCE
