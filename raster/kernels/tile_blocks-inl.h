// Drawing into the blocks of a tile: columns of vectors of samples, and the storing of blocks.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_TILE_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_TILE_BLOCKS_INL_H_
#undef KINESCOPE_RASTER_KERNELS_TILE_BLOCKS_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_TILE_BLOCKS_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/kernels/sample_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What a triangle writes: a DepthPlane and a number, the same in all lanes.
struct TriangleVectors {
  VF anchor_x, anchor_y, z, dz_dx, dz_dy, nearest, farthest;
  VU id;

  /// Part of the depth that only depends on the pixels' columns.
  HWY_INLINE VF along_row(VF x_px) const { return hn::Mul(dz_dx, hn::Sub(x_px, anchor_x)); }
  /// DepthPlane::at, with its roundings.
  HWY_INLINE VF depth(VF y_px, VF row_part) const {
    const VF row = hn::Add(z, hn::Mul(dz_dy, hn::Sub(y_px, anchor_y)));
    return hn::Min(hn::Max(hn::Add(row, row_part), nearest), farthest);
  }
};

HWY_INLINE TriangleVectors vectors_of(const TriangleRecord& t) {
  const F f;
  return {hn::Set(f, Fixed24_8::from_raw(t.x[0]).to_float()),
          hn::Set(f, Fixed24_8::from_raw(t.y[0]).to_float()),
          hn::Set(f, t.z),
          hn::Set(f, t.dz_dx),
          hn::Set(f, t.dz_dy),
          hn::Set(f, t.nearest),
          hn::Set(f, t.farthest),
          hn::Set(hn::RebindToUnsigned<F>(), t.id)};
}

/// One edge down a column of vectors: E / 256 rounded down, whose sign is exact.
struct EdgeColumn {
  VI value, step_y;
};

/// Depth-tests and writes rows [y0, y1) of a column of vectors that begins at pixel x. A sample is
/// covered where neither an edge nor `outside` is negative.
template <class Lanes>
HWY_INLINE void draw_column(const EdgeColumn (&edge)[3], VI outside, const TriangleVectors& t,
                            const Lanes& lanes, int x, int y0, int y1, TileBuffer& tile) {
  const F f;
  const I i;
  const U u;
  VI a = edge[0].value, b = edge[1].value, c = edge[2].value;
  const VF one = hn::Set(f, 1.0f);
  const VI minus_one = hn::Set(i, -1);
  const VF row_part =
      t.along_row(hn::Add(hn::ConvertTo(f, hn::Add(lanes.column, hn::Set(i, x))), lanes.x_px));
  // Exact: rows are below 2^15 and samples lie in sixteenths.
  VF py = hn::Add(hn::Set(f, static_cast<float>(y0)), lanes.y_px);
  const auto stride = static_cast<std::size_t>(tile.stride * Lanes::kSamples);
  float* depth = tile.depth.data() + lanes.place(tile, x, y0);
  std::uint32_t* id = tile.id.data() + lanes.place(tile, x, y0);
  for (int y = y0; y < y1; ++y, depth += stride, id += stride) {
    const auto covered = hn::Gt(hn::Or(hn::Or(a, b), hn::Or(c, outside)), minus_one);
    if (!hn::AllFalse(i, covered)) {
      const VF z = t.depth(py, row_part);
      const VF old_z = hn::Load(f, depth);
      const VU old_id = hn::Load(u, id);
      const auto earlier = hn::RebindMask(f, hn::Lt(t.id, old_id));
      const auto wins = hn::And(hn::RebindMask(f, covered),
                                hn::Or(hn::Lt(z, old_z), hn::And(hn::Eq(z, old_z), earlier)));
      hn::Store(hn::IfThenElse(wins, z, old_z), f, depth);
      hn::Store(hn::IfThenElse(hn::RebindMask(u, wins), t.id, old_id), u, id);
    }
    a = hn::Add(a, edge[0].step_y);
    b = hn::Add(b, edge[1].step_y);
    c = hn::Add(c, edge[2].step_y);
    py = hn::Add(py, one);
  }
}

/// Writes the samples of a block that was known by its triangle only.
template <int kSamples>
HWY_INLINE void store_block(int block, const LaneParts<kSamples>& parts, TileBuffer& tile) {
  using Lanes = SampleLanes<kSamples>;
  const F f;
  const I i;
  const U u;
  tile.stored |= std::uint64_t{1} << block;
  const int x0 = tile.rect.x0 + block % tile.block_columns * TileBuffer::kBlock;
  const int y0 = tile.rect.y0 + block / tile.block_columns * TileBuffer::kBlock;
  const TriangleRecord* const shown = tile.shown[static_cast<std::size_t>(block)];
  const auto stride = static_cast<std::size_t>(tile.stride * kSamples);
  for (const Lanes& lanes : parts.part) {
    for (int x = x0; x < x0 + TileBuffer::kBlock; x += Lanes::kPixels) {
      std::size_t at = lanes.place(tile, x, y0);
      if (shown == nullptr) {
        const VF far = hn::Set(f, 1.0f);
        const VU nothing = hn::Set(u, TileBuffer::kNothing);
        for (int r = 0; r < TileBuffer::kBlock; ++r, at += stride) {
          hn::Store(far, f, tile.depth.data() + at);
          hn::Store(nothing, u, tile.id.data() + at);
        }
        continue;
      }
      const TriangleVectors t = vectors_of(*shown);
      const VF row_part =
          t.along_row(hn::Add(hn::ConvertTo(f, hn::Add(lanes.column, hn::Set(i, x))), lanes.x_px));
      VF py = hn::Add(hn::Set(f, static_cast<float>(y0)), lanes.y_px);
      for (int r = 0; r < TileBuffer::kBlock; ++r, at += stride) {
        hn::Store(t.depth(py, row_part), f, tile.depth.data() + at);
        hn::Store(t.id, u, tile.id.data() + at);
        py = hn::Add(py, hn::Set(f, 1.0f));
      }
    }
  }
}

/// The bits of blocks, row by row, that a rectangle of the tile's pixels touches.
HWY_INLINE std::uint64_t blocks_touched(const PixelRect& rect, const TileBuffer& tile) {
  const int column0 = (rect.x0 - tile.rect.x0) >> 3, column1 = (rect.x1 - 1 - tile.rect.x0) >> 3;
  const int row0 = (rect.y0 - tile.rect.y0) >> 3, row1 = (rect.y1 - 1 - tile.rect.y0) >> 3;
  const std::uint64_t row = ((std::uint64_t{2} << (column1 - column0)) - 1) << column0;
  std::uint64_t blocks = 0;
  for (int r = row0; r <= row1; ++r) blocks |= row << (r * tile.block_columns);
  return blocks;
}

template <int kSamples>
HWY_INLINE void store_blocks(std::uint64_t blocks, const LaneParts<kSamples>& parts,
                             TileBuffer& tile) {
  for (std::uint64_t left = blocks & ~tile.stored; left != 0; left &= left - 1) {
    store_block(std::countr_zero(left), parts, tile);
  }
}

/// The farthest depth among a stored block's samples.
template <int kSamples>
HWY_INLINE float farthest_in_block(int block, const TileBuffer& tile) {
  const F f;
  constexpr std::size_t kLanes = hn::MaxLanes(F());
  constexpr int kSide = TileBuffer::kBlock;
  const int column = block % tile.block_columns, row = block / tile.block_columns;
  const auto stride = static_cast<std::size_t>(tile.stride) * kSamples;
  const float* at = tile.depth.data() + static_cast<std::size_t>(row * kSide) * stride +
                    static_cast<std::size_t>(column * kSide * kSamples);
  VF most = hn::Zero(f);
  for (int r = 0; r < kSide; ++r, at += stride) {
    HWY_UNROLL(8)
    for (std::size_t s = 0; s < kSide * kSamples; s += kLanes) {
      most = hn::Max(most, hn::Load(f, at + s));
    }
  }
  return hn::GetLane(hn::MaxOfLanes(f, most));
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_TILE_BLOCKS_INL_H_
