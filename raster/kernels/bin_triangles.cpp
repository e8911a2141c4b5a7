#include "raster/kernels/bin_triangles.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/bin_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;

/// Tiles, half open.
struct TileRange {
  int column0, row0, column1, row1;
  bool is_one() const { return column1 - column0 == 1 && row1 - row0 == 1; }
};

/// @param x_min,y_min,x_max,y_max  raw Fixed24_8
HWY_INLINE TileRange tiles_touched(int x_min, int y_min, int x_max, int y_max,
                                   const TileGrid& grid) {
  return {grid.column_of(std::max(x_min >> 8, 0)), grid.row_of(std::max(y_min >> 8, 0)),
          grid.column_of(std::min(x_max >> 8, grid.width - 1)) + 1,
          grid.row_of(std::min(y_max >> 8, grid.height - 1)) + 1};
}

HWY_INLINE TileRange tiles_touched(const CulledTriangles::Snapped& t, std::size_t i,
                                   const TileGrid& grid) {
  const auto [x_min, x_max] = std::minmax({t.x[0][i], t.x[1][i], t.x[2][i]});
  const auto [y_min, y_max] = std::minmax({t.y[0][i], t.y[1][i], t.y[2][i]});
  return tiles_touched(x_min, y_min, x_max, y_max, grid);
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

HWY_INLINE void append_vector(const CulledTriangles::Snapped& from, std::size_t i,
                              std::uint32_t first_id, TriangleChunk& chunk) {
  const F f;
  const hn::RebindToSigned<F> s;
  const U u;
  const auto n = static_cast<std::size_t>(chunk.size);
  for (std::size_t v = 0; v < 3; ++v) {
    hn::StoreU(hn::LoadU(s, from.x[v].data() + i), s, chunk.x[v].data() + n);
    hn::StoreU(hn::LoadU(s, from.y[v].data() + i), s, chunk.y[v].data() + n);
    hn::StoreU(hn::LoadU(f, from.z[v].data() + i), f, chunk.z[v].data() + n);
  }
  const auto id = hn::Add(hn::LoadU(u, from.triangle.data() + i), hn::Set(u, first_id));
  hn::StoreU(id, u, chunk.id.data() + n);
  chunk.size += static_cast<int>(hn::Lanes(f));
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

/// The tiles of a whole vector of triangles.
HWY_INLINE TileRange tiles_of_vector(const CulledTriangles::Snapped& t, std::size_t k,
                                     const TileGrid& grid) {
  const I i;
  const auto of = [&](const auto& corners, bool most) HWY_ATTR {
    const auto a = hn::LoadU(i, corners[0].data() + k), b = hn::LoadU(i, corners[1].data() + k);
    const auto c = hn::LoadU(i, corners[2].data() + k);
    return most ? hn::GetLane(hn::MaxOfLanes(i, hn::Max(hn::Max(a, b), c)))
                : hn::GetLane(hn::MinOfLanes(i, hn::Min(hn::Min(a, b), c)));
  };
  return tiles_touched(of(t.x, false), of(t.y, false), of(t.x, true), of(t.y, true), grid);
}

void BinSmallTriangles(const CulledTriangles::Snapped& t, std::uint32_t first_id,
                       const TileGrid& grid, Bins& bins) {
  const std::size_t lanes = hn::Lanes(F()), size = static_cast<std::size_t>(t.size);
  const auto bin_one = [&](std::size_t i) {
    const TileRange tiles = tiles_touched(t, i, grid);
    append_to_all(t, i, first_id, tiles, grid, tiles.is_one() ? bins.small : bins.small_across,
                  bins.triangle_pool);
  };
  std::size_t k = 0;
  for (; k + lanes <= size; k += lanes) {
    const TileRange tiles = tiles_of_vector(t, k, grid);
    if (tiles.is_one()) {
      const auto tile = static_cast<std::size_t>(tiles.row0 * grid.columns + tiles.column0);
      append_vector(t, k, first_id,
                    bins.small[tile].tail(bins.triangle_pool, static_cast<int>(lanes)));
    } else {
      for (std::size_t i = k; i < k + lanes; ++i) bin_one(i);
    }
  }
  for (; k < size; ++k) bin_one(k);
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

HWY_EXPORT(BinSmallTriangles);
HWY_EXPORT(BinMediumTriangles);

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
