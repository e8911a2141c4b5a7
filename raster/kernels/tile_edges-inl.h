// The edges of a triangle over one tile, in 32 bits.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_TILE_EDGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_TILE_EDGES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_TILE_EDGES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_TILE_EDGES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/tile_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kBlock = TileBuffer::kBlock;

/// An edge over a tile: at pixel (k, r) of it its sign is that of step_x k + step_y r + start, each
/// sample with a start of its own. Dividing by 256 (rounding down) keeps the sign, and pixels lie
/// 256 raw units apart, so the steps stay whole. An edge that crosses a tile of at most 64x64
/// pixels fits 32 bits: steps are at most 2^24, and less than 63+63+2 of them part any two values
/// at samples of the tile. One that does not cross it is all zeros.
template <int kSamples>
struct TileEdge {
  std::int32_t step_x, step_y;
  std::int32_t least, most;  ///< of the starts
  std::array<std::int32_t, kSamples> start;
};

/// A triangle in a tile.
template <int kSamples>
struct TriangleInTile {
  static constexpr int kParts = SampleLanes<kSamples>::kParts;

  const TriangleRecord* record;
  PixelRect rect;  ///< no other pixels are touched
  std::array<TileEdge<kSamples>, 3> edge;
  TriangleVectors vectors;
  VI corner[3][kParts];         ///< the edges at the vector that begins at the tile's first pixel
  VI down[3];                   ///< how much the edges rise to each lane's row
  VI across[3];                 ///< and to each lane's block
  VI least[3], most[3];         ///< over a block's samples, from its first pixel's value
  std::int32_t most_in_row[3];  ///< over a row of a block

  /// An edge at a pixel of the tile, without its start.
  std::int32_t rise(std::size_t e, int column, int row) const {
    return column * edge[e].step_x + row * edge[e].step_y;
  }
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

/// Finds the edges that cross the triangle's rectangle. False if it lies outside of one.
template <int kSamples>
HWY_INLINE bool find_edges(const PixelRect& tile, std::span<const SampleOffset> pattern,
                           TriangleInTile<kSamples>& in) {
  const TriangleRecord& t = *in.record;
  const std::int64_t width = in.rect.x1 - in.rect.x0 - 1, height = in.rect.y1 - in.rect.y0 - 1;
  std::size_t crossings = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = a == 2 ? 0 : a + 1;
    const std::int64_t dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t at_rect = dx * (in.rect.y0 - tile.y0) - dy * (in.rect.x0 - tile.x0);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::int64_t most = std::numeric_limits<std::int64_t>::min();
    TileEdge<kSamples>& edge = in.edge[crossings];
    for (std::size_t s = 0; s < kSamples; ++s) {
      const std::int64_t px = std::int64_t{tile.x0} * 256 + pattern[s].x.raw();
      const std::int64_t py = std::int64_t{tile.y0} * 256 + pattern[s].y.raw();
      const std::int64_t e = dx * (py - t.y[a]) - dy * (px - t.x[a]) - (top_left ? 0 : 1);
      const std::int64_t start = e >> 8;
      least = std::min(least, start);
      most = std::max(most, start);
      edge.start[s] = static_cast<std::int32_t>(start);  // used only if it fits
    }
    const std::int64_t rise =
        std::max<std::int64_t>(-dy * width, 0) + std::max<std::int64_t>(dx * height, 0);
    if (most + at_rect + rise < 0) return false;
    // Over the whole tile, since blocks reach beyond the rectangle.
    constexpr std::int64_t kReach = TileGrid::kMaxTile - 1;
    const std::int64_t fall =
        std::min<std::int64_t>(-dy * kReach, 0) + std::min<std::int64_t>(dx * kReach, 0);
    if (least + fall >= 0) continue;
    edge.step_x = static_cast<std::int32_t>(-dy);
    edge.step_y = static_cast<std::int32_t>(dx);
    edge.least = static_cast<std::int32_t>(least);
    edge.most = static_cast<std::int32_t>(most);
    ++crossings;
  }
  for (; crossings < 3; ++crossings) {
    TileEdge<kSamples>& edge = in.edge[crossings];
    edge.step_x = edge.step_y = edge.least = edge.most = 0;
    edge.start.fill(0);
  }
  return true;
}

template <int kSamples>
HWY_INLINE void set_vectors(const LaneParts<kSamples>& parts, TriangleInTile<kSamples>& in) {
  const I i;
  in.vectors = vectors_of(*in.record);
  for (std::size_t e = 0; e < 3; ++e) {
    const TileEdge<kSamples>& edge = in.edge[e];
    const std::int32_t over_row = edge.step_x * (kBlock - 1);
    const std::int32_t over_column = edge.step_y * (kBlock - 1);
    in.down[e] = hn::Mul(lane_numbers(i), hn::Set(i, edge.step_y));
    in.across[e] = hn::Mul(lane_numbers(i), hn::Set(i, edge.step_x * kBlock));
    in.least[e] = hn::Set(i, edge.least + std::min(over_row, 0) + std::min(over_column, 0));
    in.most[e] = hn::Set(i, edge.most + std::max(over_row, 0) + std::max(over_column, 0));
    in.most_in_row[e] = edge.most + std::max(over_row, 0);
    for (const SampleLanes<kSamples>& lanes : parts.part) {
      const VI columns = hn::Mul(lanes.column, hn::Set(i, in.edge[e].step_x));
      in.corner[e][lanes.part] = hn::Add(in_lanes(in.edge[e].start.data(), lanes), columns);
    }
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_TILE_EDGES_INL_H_
