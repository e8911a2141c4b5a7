#include "raster/kernels/bin_triangles.h"

#include <algorithm>
#include <array>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/bin_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/pack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;

/// Tiles, half open.
struct TileRange {
  int column0, row0, column1, row1;
};

HWY_INLINE TileRange tiles_touched(const CulledTriangles::Snapped& t, std::size_t i,
                                   const TileGrid& grid) {
  const auto [x_min, x_max] = std::minmax({t.x[0][i], t.x[1][i], t.x[2][i]});
  const auto [y_min, y_max] = std::minmax({t.y[0][i], t.y[1][i], t.y[2][i]});
  return {grid.column_of(std::max(x_min >> 8, 0)), grid.row_of(std::max(y_min >> 8, 0)),
          grid.column_of(std::min(x_max >> 8, grid.width - 1)) + 1,
          grid.row_of(std::min(y_max >> 8, grid.height - 1)) + 1};
}

HWY_INLINE void append_one(const CulledTriangles::Snapped& from, std::size_t i,
                           std::uint32_t first_id, TriangleChunk& chunk) {
  const auto n = static_cast<std::size_t>(chunk.size++);
  for (std::size_t v = 0; v < 3; ++v) {
    chunk.x[v][n] = from.x[v][i];
    chunk.y[v][n] = from.y[v][i];
    chunk.z[v][n] = from.z[v][i];
  }
  chunk.id[n] = first_id + from.triangle[i];
}

/// Appends a triangle to each of the tiles.
HWY_INLINE void append_to_all(const CulledTriangles::Snapped& from, std::size_t i,
                              std::uint32_t first_id, const TileRange& tiles, const TileGrid& grid,
                              std::vector<ChunkList<TriangleChunk>>& lists,
                              ChunkPool<TriangleChunk>& pool) {
  for (int row = tiles.row0; row < tiles.row1; ++row) {
    for (int column = tiles.column0; column < tiles.column1; ++column) {
      const auto tile = static_cast<std::size_t>(row * grid.columns + column);
      append_one(from, i, first_id, lists[tile].tail(pool));
    }
  }
}

/// A vector of triangles of one tile.
HWY_INLINE void append_packed(const CulledTriangles::Snapped& from, std::size_t k,
                              const Packer<I>& pack, std::uint32_t first_id, TriangleChunk& chunk) {
  const F f;
  const I i;
  const U u;
  const auto n = static_cast<std::size_t>(chunk.size);
  for (std::size_t v = 0; v < 3; ++v) {
    pack.store(hn::LoadU(i, from.x[v].data() + k), chunk.x[v].data() + n);
    pack.store(hn::LoadU(i, from.y[v].data() + k), chunk.y[v].data() + n);
    pack.store(hn::LoadU(f, from.z[v].data() + k), chunk.z[v].data() + n);
  }
  const auto id = hn::Add(hn::LoadU(u, from.triangle.data() + k), hn::Set(u, first_id));
  pack.store(id, chunk.id.data() + n);
  chunk.size += static_cast<int>(pack.count());
}

/// Numbers of tiles along one axis: pixels over a side, which is a multiple of 8 and at most 64.
/// Exact below 2^16 pixels.
struct TilesAlong {
  int end_px;
  std::int32_t per_eight;
  TilesAlong(int end, int side) : end_px(end), per_eight((65536 + side / 8 - 1) / (side / 8)) {}

  HWY_INLINE hn::Vec<I> of_pixel(hn::Vec<I> px) const {
    return hn::ShiftRight<16>(hn::Mul(hn::ShiftRight<3>(px), hn::Set(I(), per_eight)));
  }
  HWY_INLINE hn::Vec<I> of(hn::Vec<I> raw) const {
    const I i;
    return of_pixel(hn::Min(hn::Max(hn::ShiftRight<8>(raw), hn::Zero(i)), hn::Set(i, end_px - 1)));
  }
};

/// The tiles in which the boxes of several triangles begin and end.
struct TileEnds {
  hn::Vec<I> first, last;
};

HWY_INLINE TileEnds tile_ends(const CulledTriangles::Snapped& t, std::size_t k,
                              const TilesAlong& across, const TilesAlong& down, int columns) {
  const I i;
  const auto corner = [&](const auto& corners, std::size_t v)
                          HWY_ATTR { return hn::LoadU(i, corners[v].data() + k); };
  const auto least = [&](const auto& c) HWY_ATTR {
    return hn::Min(hn::Min(corner(c, 0), corner(c, 1)), corner(c, 2));
  };
  const auto most = [&](const auto& c) HWY_ATTR {
    return hn::Max(hn::Max(corner(c, 0), corner(c, 1)), corner(c, 2));
  };
  const auto row = hn::Set(i, columns);
  return {hn::Add(hn::Mul(down.of(least(t.y)), row), across.of(least(t.x))),
          hn::Add(hn::Mul(down.of(most(t.y)), row), across.of(most(t.x)))};
}

/// Calls append(pack, tile) for each tile that occurs among some lanes. Neighbours share tiles:
/// most often that is one round, or two.
template <typename Append>
HWY_INLINE void for_each_tile(hn::Vec<I> tiles, hn::Mask<I> chosen, const Append& append) {
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

void BinSmallTriangles(const CulledTriangles::Snapped& t, std::uint32_t first_id,
                       const TileGrid& grid, Bins& bins) {
  const I i;
  const std::size_t lanes = hn::Lanes(i), size = static_cast<std::size_t>(t.size);
  const TilesAlong across(grid.width, grid.tile_width), down(grid.height, grid.tile_height);
  for (std::size_t k = 0; k < size; k += lanes) {
    const TileEnds ends = tile_ends(t, k, across, down, grid.columns);
    const auto within = first_lanes(i, size - k);
    const auto is_one = hn::And(within, hn::Eq(ends.first, ends.last));
    for_each_tile(ends.first, is_one, [&](const Packer<I>& pack, std::size_t tile) HWY_ATTR {
      TriangleChunk& chunk = bins.small[tile].tail(bins.triangle_pool, static_cast<int>(lanes));
      append_packed(t, k, pack, first_id, chunk);
    });
    for (unsigned left = Packer<I>(hn::AndNot(is_one, within)).bits(); left != 0;
         left &= left - 1) {
      const std::size_t at = k + static_cast<std::size_t>(std::countr_zero(left));
      append_to_all(t, at, first_id, tiles_touched(t, at, grid), grid, bins.small_across,
                    bins.triangle_pool);
    }
  }
}

void BinMediumTriangles(const CulledTriangles::Snapped& t, std::uint32_t first_id,
                        const TileGrid& grid, Bins& bins) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(t.size); ++i) {
    append_to_all(t, i, first_id, tiles_touched(t, i, grid), grid, bins.medium, bins.triangle_pool);
  }
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
                         const TileGrid& grid, Bins& bins) {
  HWY_DYNAMIC_DISPATCH(BinSmallTriangles)(triangles, first_id, grid, bins);
}

void bin_medium_triangles(const CulledTriangles::Snapped& triangles, std::uint32_t first_id,
                          const TileGrid& grid, Bins& bins) {
  HWY_DYNAMIC_DISPATCH(BinMediumTriangles)(triangles, first_id, grid, bins);
}

}  // namespace kinescope
#endif
