#include "raster/kernels/bin_triangles.h"

#include <array>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/bin_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/pack-inl.h"
#include "raster/kernels/set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Numbers of tiles along one axis: pixels over a side, which is a multiple of 8 and at most 64.
/// Exact below 2^16 pixels.
struct TilesAlong {
  int end_px, side;
  std::int32_t per_eight;
  TilesAlong(int end, int tile_side)
      : end_px(end), side(tile_side), per_eight((65536 + tile_side / 8 - 1) / (tile_side / 8)) {}

  HWY_INLINE VI of_pixel(VI px) const {
    return hn::ShiftRight<16>(hn::Mul(hn::ShiftRight<3>(px), hn::Set(I(), per_eight)));
  }
  HWY_INLINE VI of_any_pixel(VI px) const {
    const I i;
    return of_pixel(hn::Min(hn::Max(px, hn::Zero(i)), hn::Set(i, end_px - 1)));
  }
};

/// The tiles along one axis that triangles touch, from the first to the last.
struct TileEnds {
  VI first, last;
};

/// Of boxes around three corners: the tiles with the first and the last pixel that may have a
/// sample in the box.
HWY_INLINE TileEnds tile_ends(const VI (&raw)[3], Fixed24_8 least_offset, Fixed24_8 most_offset,
                              const TilesAlong& tiles) {
  return {tiles.of_any_pixel(first_pixel(least(raw), most_offset)),
          tiles.of_any_pixel(last_pixel(most(raw), least_offset))};
}

/// Calls append(pack, tile) for each tile that occurs among some lanes. Neighbours share tiles:
/// most often that is one round, or two.
template <typename Append>
HWY_INLINE void for_each_tile(VI tiles, hn::Mask<I> chosen, const Append& append) {
  const I i;
  alignas(64) std::array<std::int32_t, hn::MaxLanes(I())> tile;
  hn::Store(tiles, i, tile.data());
  for (unsigned left = Packer<I>(chosen).bits(); left != 0;) {
    const std::int32_t at = tile[static_cast<std::size_t>(std::countr_zero(left))];
    const Packer<I> pack(hn::And(chosen, hn::Eq(tiles, hn::Set(i, at))));
    append(pack, static_cast<std::size_t>(at));
    left &= ~unsigned{pack.bits()};
  }
}

void BinPixels(const CulledTriangles::Pixels& pixels, std::uint32_t first_id, const TileGrid& grid,
               Bins& bins) {
  const F f;
  const I i;
  const U u;
  const std::size_t lanes = hn::Lanes(i), size = static_cast<std::size_t>(pixels.size);
  const TilesAlong across(grid.width, grid.tile_width), down(grid.height, grid.tile_height);
  for (std::size_t k = 0; k < size; k += lanes) {
    const auto xy = hn::LoadU(u, pixels.xy.data() + k);
    const auto within = first_lanes(i, size - k);
    // What lies beyond the last pixel is some pixel too: there its number is 0.
    const auto known = hn::IfThenElseZero(hn::RebindMask(u, within), xy);
    const auto x = hn::BitCast(i, hn::And(known, hn::Set(u, 0xffff)));
    const auto y = hn::BitCast(i, hn::ShiftRight<16>(known));
    const auto column = across.of_pixel(x), row = down.of_pixel(y);
    const auto in_x = hn::Sub(x, hn::Mul(column, hn::Set(i, grid.tile_width)));
    const auto in_y = hn::Sub(y, hn::Mul(row, hn::Set(i, grid.tile_height)));
    const auto place = hn::Or(hn::ShiftLeft<8>(in_y), in_x);
    const auto z = hn::LoadU(f, pixels.z.data() + k);
    const auto id = hn::Add(hn::LoadU(u, pixels.triangle.data() + k), hn::Set(u, first_id));
    const auto tiles = hn::Add(hn::Mul(row, hn::Set(i, grid.columns)), column);
    for_each_tile(tiles, within, [&](const Packer<I>& pack, std::size_t tile) HWY_ATTR {
      PixelChunk& chunk = bins.pixels[tile].tail(bins.pixel_pool, static_cast<int>(lanes));
      const auto n = static_cast<std::size_t>(chunk.size);
      pack.store(hn::BitCast(u, place), chunk.place.data() + n);
      pack.store(z, chunk.z.data() + n);
      pack.store(id, chunk.id.data() + n);
      chunk.size += static_cast<int>(pack.count());
    });
  }
}

/// Several triangles on their way to the bins.
struct Leaving {
  Corners at;
  VF z0;
  alignas(64) std::array<BinnedTriangle, hn::MaxLanes(I())> binned;  // but the first four words
};

HWY_INLINE void load(const CulledTriangles::Snapped& t, std::size_t k, std::uint32_t first_id,
                     Leaving& out) {
  const F f;
  const U u;
  HWY_UNROLL(3)
  for (std::size_t v = 0; v < 3; ++v) {
    out.at.x[v] = hn::LoadU(I(), t.x[v].data() + k);
    out.at.y[v] = hn::LoadU(I(), t.y[v].data() + k);
  }
  out.z0 = hn::LoadU(f, t.z[0].data() + k);
  const VU id = hn::Add(hn::LoadU(u, t.triangle.data() + k), hn::Set(u, first_id));
  const FourVectors<VU> last = {hn::BitCast(u, hn::LoadU(f, t.z[1].data() + k)),
                                hn::BitCast(u, hn::LoadU(f, t.z[2].data() + k)), id, id};
  store_fours(u, last, [&](std::size_t j) { return out.binned[j].word.data() + 4; });
}

/// Appends each of the chosen triangles to a tile of its own.
struct Binner {
  const TilesAlong across, down;
  int columns;
  ChunkPool<TriangleChunk>& pool;

  Binner(const TileGrid& grid, Bins& bins)
      : across(grid.width, grid.tile_width),
        down(grid.height, grid.tile_height),
        columns(grid.columns),
        pool(bins.triangle_pool) {}

  HWY_INLINE void append(Leaving& t, VI column, VI row, hn::Mask<I> chosen,
                         std::vector<ChunkList<TriangleChunk>>& lists) const {
    const I i;
    const U u;
    const VI x0 = hn::ShiftLeft<8>(hn::Mul(column, hn::Set(i, across.side)));
    const VI y0 = hn::ShiftLeft<8>(hn::Mul(row, hn::Set(i, down.side)));
    const VI low = hn::Set(i, 0xffff);
    const auto xy = [&](std::size_t v) HWY_ATTR {
      const VI x = hn::And(hn::Sub(t.at.x[v], x0), low);
      return hn::BitCast(u, hn::Or(hn::ShiftLeft<16>(hn::Sub(t.at.y[v], y0)), x));
    };
    const FourVectors<VU> first = {xy(0), xy(1), xy(2), hn::BitCast(u, t.z0)};
    store_fours(u, first, [&](std::size_t j) { return t.binned[j].word.data(); });
    const VI tiles = hn::Add(hn::Mul(row, hn::Set(i, columns)), column);
    for_each_tile(tiles, chosen, [&](const Packer<I>& pack, std::size_t tile) HWY_ATTR {
      const int count = static_cast<int>(pack.count());
      TriangleChunk& chunk = lists[tile].tail(pool, count);
      BinnedTriangle* to = chunk.triangle.data() + chunk.size;
      chunk.size += count;
      for (unsigned lanes = pack.bits(); lanes != 0; lanes &= lanes - 1, ++to) {
        copy(t.binned[static_cast<std::size_t>(std::countr_zero(lanes))], *to);
      }
    });
  }

  /// In the halves that were stored just now: a wider load would have to wait for both.
  static HWY_INLINE void copy(const BinnedTriangle& from, BinnedTriangle& to) {
    const hn::CappedTag<std::uint32_t, 4> d;
    for (std::size_t n = 0; n < to.word.size(); n += hn::Lanes(d)) {
      hn::Store(hn::Load(d, from.word.data() + n), d, to.word.data() + n);
    }
  }

  /// To all tiles that the chosen triangles touch.
  HWY_INLINE void append_to_all(Leaving& t, const TileEnds& x, const TileEnds& y,
                                hn::Mask<I> chosen,
                                std::vector<ChunkList<TriangleChunk>>& lists) const {
    const I i;
    const VI one = hn::Set(i, 1);
    VI row = y.first;
    for (auto in_row = chosen; !hn::AllFalse(i, in_row);) {
      VI column = x.first;
      for (auto there = in_row; !hn::AllFalse(i, there);) {
        append(t, column, row, there, lists);
        column = hn::Add(column, one);
        there = hn::AndNot(hn::Gt(column, x.last), there);
      }
      row = hn::Add(row, one);
      in_row = hn::AndNot(hn::Gt(row, y.last), in_row);
    }
  }
};

/// @param within  for the triangles that touch one tile
/// @param others  for those that touch more
HWY_INLINE void bin_all(const CulledTriangles::Snapped& t, std::uint32_t first_id,
                        const SampleLimits& limits, const TileGrid& grid, Bins& bins,
                        std::vector<ChunkList<TriangleChunk>>& within,
                        std::vector<ChunkList<TriangleChunk>>& others) {
  const I i;
  const auto size = static_cast<std::size_t>(t.size);
  const Binner binner(grid, bins);
  Leaving leaving;
  for (std::size_t k = 0; k < size; k += hn::Lanes(i)) {
    load(t, k, first_id, leaving);
    const TileEnds x = tile_ends(leaving.at.x, limits.least_x, limits.most_x, binner.across);
    const TileEnds y = tile_ends(leaving.at.y, limits.least_y, limits.most_y, binner.down);
    const auto there = first_lanes(i, size - k);
    const auto is_one = hn::And(hn::Eq(x.first, x.last), hn::Eq(y.first, y.last));
    binner.append(leaving, x.first, y.first, hn::And(there, is_one), within);
    binner.append_to_all(leaving, x, y, hn::AndNot(is_one, there), others);
  }
}

void BinSmallTriangles(const CulledTriangles::Snapped& t, std::uint32_t first_id,
                       const SampleLimits& limits, const TileGrid& grid, Bins& bins) {
  bin_all(t, first_id, limits, grid, bins, bins.small, bins.small_across);
}

void BinMediumTriangles(const CulledTriangles::Snapped& t, std::uint32_t first_id,
                        const SampleLimits& limits, const TileGrid& grid, Bins& bins) {
  bin_all(t, first_id, limits, grid, bins, bins.medium, bins.medium);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(BinPixels);
HWY_EXPORT(BinSmallTriangles);
HWY_EXPORT(BinMediumTriangles);

void bin_pixels(const CulledTriangles::Pixels& pixels, std::uint32_t first_id, const TileGrid& grid,
                Bins& bins) {
  HWY_DYNAMIC_DISPATCH(BinPixels)(pixels, first_id, grid, bins);
}

void bin_small_triangles(const CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                         const SampleLimits& limits, const TileGrid& grid, Bins& bins) {
  HWY_DYNAMIC_DISPATCH(BinSmallTriangles)(triangles, first_id, limits, grid, bins);
}

void bin_medium_triangles(const CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                          const SampleLimits& limits, const TileGrid& grid, Bins& bins) {
  HWY_DYNAMIC_DISPATCH(BinMediumTriangles)(triangles, first_id, limits, grid, bins);
}

}  // namespace kinescope
#endif
