// Blocks of 8x8 pixels that an edge crosses are drawn sample by sample; those within all three
// edges become the triangle's at once, unless what they show may be nearer. Source: F. Giesen,
// "Optimizing software occlusion culling", 2013, for the corner test of blocks.
#include "raster/kernels/large_triangles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/large_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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
  VI corner[3][kParts];  ///< the edges at the vector that begins at the tile's first pixel
  VI down[3];            ///< how much the edges rise to each lane's row

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
HWY_INLINE void set_vectors(const LaneParts<kSamples>& parts, TriangleInTile<kSamples>& in) {
  const I i;
  in.vectors = vectors_of(*in.record);
  for (std::size_t e = 0; e < 3; ++e) {
    in.down[e] = hn::Mul(lane_numbers(i), hn::Set(i, in.edge[e].step_y));
    for (const SampleLanes<kSamples>& lanes : parts.part) {
      const VI columns = hn::Mul(lanes.column, hn::Set(i, in.edge[e].step_x));
      in.corner[e][lanes.part] = hn::Add(in_lanes(in.edge[e].start.data(), lanes), columns);
    }
  }
}

/// The rows of a block in which some of a few columns may be covered, from the first to the last.
struct RowRange {
  int first, end;
};

/// @param column,row  pixel of the tile where the block's columns begin
template <int kSamples>
HWY_INLINE RowRange rows_covered(const TriangleInTile<kSamples>& in, int column, int row,
                                 int columns) {
  const I i;
  std::uint32_t rows = 0;
  for (int r = 0; r < kBlock; r += static_cast<int>(hn::Lanes(i))) {
    VI most = hn::Zero(i);
    for (std::size_t e = 0; e < 3; ++e) {
      const TileEdge<kSamples>& edge = in.edge[e];
      const std::int32_t start = edge.most + std::max((columns - 1) * edge.step_x, 0);
      most = hn::Or(most, hn::Add(in.down[e], hn::Set(i, start + in.rise(e, column, row + r))));
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(i, hn::Gt(most, hn::Set(i, -1)), bits);
    rows |= std::uint32_t{bits[0]} << r;
  }
  return {std::countr_zero(rows | 1u << kBlock), 32 - std::countl_zero(rows)};
}

/// Draws the part of a triangle that lies in a block, sample by sample.
/// @param column,row  the block's first pixel, counted from the tile's
template <int kSamples>
HWY_INLINE void draw_samples(const TriangleInTile<kSamples>& in, int column, int row,
                             const LaneParts<kSamples>& parts, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  const I i;
  for (int c = column; c < column + kBlock; c += Lanes::kPixels) {
    const RowRange rows = rows_covered(in, c, row, Lanes::kPixels);
    const int x = tile.rect.x0 + c;
    int y0 = tile.rect.y0 + row + rows.first, y1 = tile.rect.y0 + row + rows.end;
    if (in.record->clipped) {
      y0 = std::max(y0, in.rect.y0);
      y1 = std::min(y1, in.rect.y1);
    }
    if (y0 >= y1) continue;
    for (const Lanes& lanes : parts.part) {
      EdgeColumn edge[3];
      for (std::size_t e = 0; e < 3; ++e) {
        const std::int32_t rise = in.rise(e, c, y0 - tile.rect.y0);
        edge[e] = {hn::Add(in.corner[e][lanes.part], hn::Set(i, rise)),
                   hn::Set(i, in.edge[e].step_y)};
      }
      VI outside = hn::Zero(i);
      if (in.record->clipped) {
        const VI pixel = hn::Add(lanes.column, hn::Set(i, x));
        outside = hn::Or(hn::Sub(pixel, hn::Set(i, in.rect.x0)),
                         hn::Sub(hn::Set(i, in.rect.x1 - 1), pixel));
      }
      draw_column(edge, outside, in.vectors, lanes, x, y0, y1, tile);
    }
  }
}

/// The farthest depth among a stored block's samples.
HWY_INLINE float farthest_in_block(int column, int row, const TileBuffer& tile) {
  const F f;
  const auto samples = static_cast<std::size_t>(tile.samples);
  const std::size_t stride = static_cast<std::size_t>(tile.stride) * samples;
  const float* at = tile.depth.data() + static_cast<std::size_t>(row * kBlock) * stride +
                    static_cast<std::size_t>(column * kBlock) * samples;
  VF most = hn::Zero(f);
  for (int r = 0; r < kBlock; ++r, at += stride) {
    for (std::size_t s = 0; s < kBlock * samples; s += hn::Lanes(f)) {
      most = hn::Max(most, hn::Load(f, at + s));
    }
  }
  return hn::GetLane(hn::MaxOfLanes(f, most));
}

/// The triangle in one block that it touches; `covers` if all of the block's samples are its.
/// @return whether the block's farthest depth may have come nearer
template <int kSamples>
HWY_INLINE bool draw_in_block(const TriangleInTile<kSamples>& in, int column, int row, bool covers,
                              const LaneParts<kSamples>& parts, TileBuffer& tile) {
  const TriangleRecord& t = *in.record;
  const int block = row * tile.block_columns + column;
  const auto at = static_cast<std::size_t>(block);
  const std::uint64_t bit = std::uint64_t{1} << block;
  const int x0 = tile.rect.x0 + column * kBlock, y0 = tile.rect.y0 + row * kBlock;
  const PixelRect rect = {x0, y0, x0 + kBlock, y0 + kBlock};
  if (t.clipped) {
    covers = covers && x0 >= in.rect.x0 && y0 >= in.rect.y0 && rect.x1 <= in.rect.x1 &&
             rect.y1 <= in.rect.y1;
  }
  // Bounds for the triangle do where it is nearer than all that the block shows.
  DepthRange range = {t.nearest, t.farthest};
  if (covers || !(range.farthest < tile.block_nearest[at])) {
    range = depth_range(t, rect);
    if (range.nearest > tile.block_farthest[at]) return false;
    // Triangles that cover the block only together may hide this one.
    if ((tile.stale & tile.stored & bit) != 0 && range.nearest > tile.block_nearest[at]) {
      tile.stale &= ~bit;
      tile.block_farthest[at] = farthest_in_block(column, row, tile);
      if (range.nearest > tile.block_farthest[at]) return true;
    }
  }
  if (covers && range.farthest < tile.block_nearest[at]) {
    tile.shown[at] = in.record;
    tile.stored &= ~bit;
    tile.block_nearest[at] = range.nearest;
    tile.block_farthest[at] = range.farthest;
    return true;
  }
  if (!tile.is_stored(block)) store_block(block, parts, tile);
  draw_samples(in, column * kBlock, row * kBlock, parts, tile);
  tile.stale |= bit;
  tile.block_nearest[at] = std::min(tile.block_nearest[at], range.nearest);
  if (covers) tile.block_farthest[at] = std::min(tile.block_farthest[at], range.farthest);
  return covers;
}

/// Which blocks, of as many in a row as a vector has lanes, touch the triangle or lie within it.
struct BlockBits {
  std::uint32_t touched, within;
};

template <int kSamples>
HWY_INLINE BlockBits classify(const TriangleInTile<kSamples>& in, int column, int row) {
  const I i;
  VI least = hn::Zero(i), most = hn::Zero(i);  // negative if one edge's is
  const VI columns = lanes_from(i, column * kBlock);
  const VI in_block = hn::Mul(lane_numbers(i), hn::Set(i, kBlock - 1));
  for (const TileEdge<kSamples>& e : in.edge) {
    const std::int32_t across = e.step_x * (kBlock - 1), down = e.step_y * (kBlock - 1);
    const VI corner = hn::Add(hn::Mul(hn::Add(columns, in_block), hn::Set(i, e.step_x)),
                              hn::Set(i, row * kBlock * e.step_y));
    least = hn::Or(least,
                   hn::Add(corner, hn::Set(i, e.least + std::min(across, 0) + std::min(down, 0))));
    most =
        hn::Or(most, hn::Add(corner, hn::Set(i, e.most + std::max(across, 0) + std::max(down, 0))));
  }
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(i, hn::Gt(most, hn::Set(i, -1)), bits);
  const std::uint32_t touched = bits[0];
  hn::StoreMaskBits(i, hn::Gt(least, hn::Set(i, -1)), bits);
  return {touched, bits[0]};
}

/// @return as draw_in_block, of any block
template <int kSamples>
HWY_INLINE bool draw_in_tile(const TriangleInTile<kSamples>& in, const LaneParts<kSamples>& parts,
                             TileBuffer& tile) {
  const int lanes = static_cast<int>(hn::Lanes(I()));
  const int column0 = (in.rect.x0 - tile.rect.x0) / kBlock;
  const int column1 = (in.rect.x1 - 1 - tile.rect.x0) / kBlock + 1;
  const int row1 = (in.rect.y1 - 1 - tile.rect.y0) / kBlock + 1;
  bool nearer = false;
  for (int row = (in.rect.y0 - tile.rect.y0) / kBlock; row < row1; ++row) {
    for (int column = column0; column < column1; column += lanes) {
      const BlockBits bits = classify(in, column, row);
      const std::uint32_t there = (1u << std::min(column1 - column, lanes)) - 1;
      for (std::uint32_t left = bits.touched & there; left != 0; left &= left - 1) {
        const int lane = std::countr_zero(left);
        nearer |=
            draw_in_block(in, column + lane, row, (bits.within >> lane & 1) != 0, parts, tile);
      }
    }
  }
  return nearer;
}

HWY_INLINE float farthest_of(const TileBuffer& tile) {
  const F f;
  VF most = hn::Zero(f);
  for (std::size_t b = 0; b < TileBuffer::kMaxBlocks; b += hn::Lanes(f)) {
    most = hn::Max(most, hn::Load(f, tile.block_farthest.data() + b));
  }
  return hn::GetLane(hn::MaxOfLanes(f, most));
}

template <int kSamples>
HWY_INLINE void draw_all(std::span<const TriangleRecord* const> records,
                         std::span<const SampleOffset> pattern, TileBuffer& tile) {
  const LaneParts<kSamples> parts(pattern);
  TriangleInTile<kSamples> in;
  for (const TriangleRecord* const record : records) {
    const TriangleRecord& t = *record;
    in.record = record;
    in.rect = {std::max<int>(t.x0, tile.rect.x0), std::max<int>(t.y0, tile.rect.y0),
               std::min<int>(t.x1, tile.rect.x1), std::min<int>(t.y1, tile.rect.y1)};
    if (t.farthest > tile.farthest && depth_range(t, in.rect).nearest > tile.farthest) continue;
    if (!find_edges(tile.rect, pattern, in)) continue;
    set_vectors(parts, in);
    if (draw_in_tile(in, parts, tile)) tile.farthest = farthest_of(tile);
  }
}

void DrawLargeTriangles(std::span<const TriangleRecord* const> records,
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

template <int kSamples>
HWY_INLINE void store_all(std::span<const SampleOffset> pattern, TileBuffer& tile) {
  const int blocks = tile.block_columns * tile.block_rows;
  const LaneParts<kSamples> parts(pattern);
  store_blocks(~std::uint64_t{0} >> (64 - blocks), parts, tile);
}

void StoreAllBlocks(std::span<const SampleOffset> pattern, TileBuffer& tile) {
  switch (pattern.size()) {
    case 1:
      return store_all<1>(pattern, tile);
    case 4:
      return store_all<4>(pattern, tile);
    default:
      return store_all<8>(pattern, tile);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawLargeTriangles);
HWY_EXPORT(StoreAllBlocks);

void draw_large_triangles(std::span<const TriangleRecord* const> records,
                          std::span<const SampleOffset> pattern, TileBuffer& tile) {
  if (records.empty()) return;
  HWY_DYNAMIC_DISPATCH(DrawLargeTriangles)(records, pattern, tile);
}

void store_all_blocks(std::span<const SampleOffset> pattern, TileBuffer& tile) {
  HWY_DYNAMIC_DISPATCH(StoreAllBlocks)(pattern, tile);
}

}  // namespace kinescope
#endif
