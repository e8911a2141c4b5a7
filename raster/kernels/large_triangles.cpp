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

#include "raster/kernels/tile_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

/// Rows of a block, counted from its first, half open.
struct RowRange {
  int first, end;
};

/// From the first to the last row in which some sample may be covered.
/// @param column,row  the block's first pixel, counted from the tile's
template <int kSamples>
HWY_INLINE RowRange rows_covered(const TriangleInTile<kSamples>& in, int column, int row) {
  const I i;
  std::uint32_t rows = 0;
  for (int r = 0; r < kBlock; r += static_cast<int>(hn::Lanes(i))) {
    VI most = hn::Zero(i);
    HWY_UNROLL(3)
    for (std::size_t e = 0; e < 3; ++e) {
      const std::int32_t start = in.most_in_row[e] + in.rise(e, column, row + r);
      most = hn::Or(most, hn::Add(in.down[e], hn::Set(i, start)));
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
  const RowRange rows = rows_covered(in, column, row);
  int y0 = tile.rect.y0 + row + rows.first, y1 = tile.rect.y0 + row + rows.end;
  if (in.record->clipped) {
    y0 = std::max(y0, in.rect.y0);
    y1 = std::min(y1, in.rect.y1);
  }
  if (y0 >= y1) return;
  for (const Lanes& lanes : parts.part) {
    EdgeColumn edge[3];
    VI step_x[3];  // to the next vector
    HWY_UNROLL(3)
    for (std::size_t e = 0; e < 3; ++e) {
      const std::int32_t rise = in.rise(e, column, y0 - tile.rect.y0);
      edge[e] = {hn::Add(in.corner[e][lanes.part], hn::Set(i, rise)),
                 hn::Set(i, in.edge[e].step_y)};
      step_x[e] = hn::Set(i, in.edge[e].step_x * Lanes::kPixels);
    }
    for (int c = column; c < column + kBlock; c += Lanes::kPixels) {
      const int x = tile.rect.x0 + c;
      VI outside = hn::Zero(i);
      if (in.record->clipped) {
        const VI pixel = hn::Add(lanes.column, hn::Set(i, x));
        outside = hn::Or(hn::Sub(pixel, hn::Set(i, in.rect.x0)),
                         hn::Sub(hn::Set(i, in.rect.x1 - 1), pixel));
      }
      draw_column(edge, outside, in.vectors, lanes, x, y0, y1, tile);
      HWY_UNROLL(3)
      for (std::size_t e = 0; e < 3; ++e) edge[e].value = hn::Add(edge[e].value, step_x[e]);
    }
  }
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
      tile.block_farthest[at] = farthest_in_block<kSamples>(block, tile);
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
  HWY_UNROLL(3)
  for (std::size_t e = 0; e < 3; ++e) {
    const VI corner = hn::Add(in.across[e], hn::Set(i, in.rise(e, column * kBlock, row * kBlock)));
    least = hn::Or(least, hn::Add(corner, in.least[e]));
    most = hn::Or(most, hn::Add(corner, in.most[e]));
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
