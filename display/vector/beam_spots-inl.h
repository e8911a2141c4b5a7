// A few spots onto a tile: products of their shares of columns and rows. Included once for
// each instruction set, hence the unusual guard.
#if defined(KINESCOPE_DISPLAY_BEAM_SPOTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_DISPLAY_BEAM_SPOTS_INL_H_
#undef KINESCOPE_DISPLAY_BEAM_SPOTS_INL_H_
#else
#define KINESCOPE_DISPLAY_BEAM_SPOTS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "display/vector/beam_target-inl.h"
#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Spots are drawn by rows of up to sixteen pixels, which hold most of them.
using W = hn::CappedTag<float, 16>;
using Wide = hn::Vec<W>;
constexpr W w;
HWY_INLINE int wide_lanes() { return static_cast<int>(hn::Lanes(w)); }
HWY_INLINE Wide wide(float v) { return hn::Set(w, v); }

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
using Axes = std::array<std::array<float, kAxis>, BeamSpots::kMost>;

/// Of each lane the next one; of the last itself.
HWY_INLINE auto next_lanes() {
  const hn::RebindToSigned<W> i;
  const auto next = hn::Add(lane_numbers(i), hn::Set(i, 1));
  return hn::IndicesFromVec(w, hn::Min(next, hn::Set(i, wide_lanes() - 1)));
}
HWY_INLINE int share_lanes() { return std::max(1, wide_lanes() - 1); }
/// Deviations a pixel.
HWY_INLINE float scale_of(float sigma) { return 1 / std::max(sigma, kLeastSigma); }

/// A spot's shares of as many pixels of an axis as share_lanes(), and 0. Each is the difference of
/// the distribution at its two edges, which are neighbouring lanes. @param scale deviations a pixel
/// @param start of the first edge, deviations
HWY_INLINE Wide axis_shares(float start, float scale) {
  const Wide edges = hn::MulAdd(lane_numbers(w), wide(scale), wide(start));
  const Wide below = normal_below(w, edges);
  if (wide_lanes() == 1) return hn::Sub(normal_below(w, wide(start + scale)), below);
  return hn::Sub(hn::TableLookupLanes(below, next_lanes()), below);
}

/// Some spots of a tile, by their shares of rows.
template <int kCount>
HWY_INLINE void draw_products(const BeamSpots& spots, const Axes& rows, const Reached& across,
                              const Reached& down, const Target& target) {
  const Target to = target;
  const Wide weight = wide(to.planes.weight[0]), zero = hn::Zero(w);
  for (int x = 0; x < across.count(); x += share_lanes()) {
    const auto inside = hn::Lt(lane_numbers(w), wide(static_cast<float>(across.count() - x)));
    const auto column = [&](std::size_t k) {
      const float scale = scale_of(spots.sigma[k]);
      const float start = (static_cast<float>(across.begin + x) - spots.x[k]) * scale;
      return hn::IfThenElseZero(inside, axis_shares(start, scale));
    };
    const Wide a = column(0), b = kCount > 1 ? column(1) : zero;
    const Wide c = kCount > 2 ? column(2) : zero, e = kCount > 3 ? column(3) : zero;
    const Wide f = kCount > 4 ? column(4) : zero, g = kCount > 5 ? column(5) : zero;
    int place = down.begin * kBeamTile + across.begin + x;
    for (std::size_t y = 0; y < static_cast<std::size_t>(down.count()); ++y) {
      Wide sum = hn::Mul(a, wide(rows[0][y]));
      if (kCount > 1) sum = hn::MulAdd(b, wide(rows[1][y]), sum);
      if (kCount > 2) sum = hn::MulAdd(c, wide(rows[2][y]), sum);
      if (kCount > 3) sum = hn::MulAdd(e, wide(rows[3][y]), sum);
      if (kCount > 4) sum = hn::MulAdd(f, wide(rows[4][y]), sum);
      if (kCount > 5) sum = hn::MulAdd(g, wide(rows[5][y]), sum);
      float* const light = to.first + place;
      hn::StoreU(hn::MulAdd(weight, sum, hn::LoadU(w, light)), w, light);
      for (std::size_t i = 1; i < to.count; ++i) {
        float* const other = to.tile.light + to.planes.offset[i] + place;
        hn::StoreU(hn::MulAdd(wide(to.planes.weight[i]), sum, hn::LoadU(w, other)), w, other);
      }
      place += kBeamTile;
    }
  }
}

/// A few spots, their places in the tile.
HWY_INLINE void draw_spots(const BeamSpots& spots, const Target& target) {
  const auto count = static_cast<std::size_t>(spots.count);
  float left = spots.x[0], right = left, top = spots.y[0], bottom = top, sigma = spots.sigma[0];
  for (std::size_t k = 1; k < count; ++k) {
    left = std::min(left, spots.x[k]), right = std::max(right, spots.x[k]);
    top = std::min(top, spots.y[k]), bottom = std::max(bottom, spots.y[k]);
    sigma = std::max(sigma, spots.sigma[k]);
  }
  const float reach = kSpotReach * std::max(sigma, kLeastSigma);
  const Reached across(left, right, reach), down(top, bottom, reach);
  if (across.count() <= 0 || down.count() <= 0) return;
  Axes rows;
  for (std::size_t k = 0; k < count; ++k) {
    const float scale = scale_of(spots.sigma[k]);
    const float start = (static_cast<float>(down.begin) - spots.y[k]) * scale;
    const Wide share = wide(spots.share[k]);
    for (int y = 0; y < down.count(); y += share_lanes()) {
      const Wide shares = axis_shares(start + static_cast<float>(y) * scale, scale);
      hn::StoreU(hn::Mul(share, shares), w, rows[k].data() + y);
    }
  }
  switch (count) {
    case 1:
      return draw_products<1>(spots, rows, across, down, target);
    case 2:
      return draw_products<2>(spots, rows, across, down, target);
    case 3:
      return draw_products<3>(spots, rows, across, down, target);
    case 4:
      return draw_products<4>(spots, rows, across, down, target);
    case 5:
      return draw_products<5>(spots, rows, across, down, target);
    default:
      return draw_products<6>(spots, rows, across, down, target);
  }
}

}  // namespace
}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
