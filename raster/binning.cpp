#include "raster/binning.h"

#include <algorithm>

namespace kinescope {
namespace {

/// The edges at the corner of a tile where each is greatest, stepped from tile to tile: if one is
/// negative there, the triangle misses the tile.
struct EdgesOverTiles {
  using Values = std::array<std::int64_t, 3>;
  Values first, step_x, step_y;

  EdgesOverTiles(const SnappedTriangle& t, const TileGrid& grid, int column, int row) {
    const auto raw = [](int px) { return std::int64_t{px} * 256; };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = i == 2 ? 0 : i + 1;
      const std::int64_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
      // E grows with x where the edge goes up, and with y where it goes right.
      const std::int64_t x = raw((column + (dy < 0 ? 1 : 0)) * grid.tile_width);
      const std::int64_t y = raw((row + (dx > 0 ? 1 : 0)) * grid.tile_height);
      first[i] = t.edge(static_cast<int>(i), x, y);
      step_x[i] = -dy * raw(grid.tile_width);
      step_y[i] = dx * raw(grid.tile_height);
    }
  }
  static bool any_negative(const Values& e) { return (e[0] | e[1] | e[2]) < 0; }
  static void advance(const Values& step, Values& e) {
    for (std::size_t i = 0; i < 3; ++i) e[i] += step[i];
  }
};

TriangleRecord record_of(const SnappedTriangle& t, std::uint32_t id, const PixelRect& box) {
  TriangleRecord r;
  r.x = t.x;
  r.y = t.y;
  r.id = id;
  r.z = t.depth.z;
  r.dz_dx = t.depth.dz_dx;
  r.dz_dy = t.depth.dz_dy;
  r.nearest = t.depth.nearest;
  r.farthest = t.depth.farthest;
  r.x0 = static_cast<std::int16_t>(box.x0);
  r.y0 = static_cast<std::int16_t>(box.y0);
  r.x1 = static_cast<std::int16_t>(box.x1);
  r.y1 = static_cast<std::int16_t>(box.y1);
  return r;
}

}  // namespace

PixelRect pixel_box(const SnappedTriangle& t, std::span<const SampleOffset> pattern,
                    const TileGrid& grid) {
  const SampleLimits limits = sample_limits(pattern);
  const auto [x_min, x_max] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [y_min, y_max] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const auto first = [](std::int32_t raw, Fixed24_8 o) { return (raw - o.raw() + 255) >> 8; };
  const auto end = [](std::int32_t raw, Fixed24_8 o) { return ((raw - o.raw()) >> 8) + 1; };
  return {std::max(first(x_min, limits.most_x), 0), std::max(first(y_min, limits.most_y), 0),
          std::min(end(x_max, limits.least_x), grid.width),
          std::min(end(y_max, limits.least_y), grid.height)};
}

bool bin_triangle(const SnappedTriangle& t, std::uint32_t id, std::span<const SampleOffset> pattern,
                  const PixelRect& clip, const TileGrid& grid,
                  std::span<ChunkList<RecordChunk>> tiles, ChunkPool<RecordChunk>& pool) {
  const PixelRect whole = pixel_box(t, pattern, grid);
  const PixelRect box = intersection(whole, clip);
  if (box.empty()) return false;
  TriangleRecord record = record_of(t, id, box);
  record.clipped = box != whole;
  const int column0 = grid.column_of(box.x0), column1 = grid.column_of(box.x1 - 1);
  const int row0 = grid.row_of(box.y0), row1 = grid.row_of(box.y1 - 1);
  const EdgesOverTiles edges(t, grid, column0, row0);
  EdgesOverTiles::Values at_row = edges.first;
  for (int row = row0; row <= row1; ++row, EdgesOverTiles::advance(edges.step_y, at_row)) {
    EdgesOverTiles::Values at = at_row;
    for (int column = column0; column <= column1; ++column) {
      const bool misses = EdgesOverTiles::any_negative(at);
      EdgesOverTiles::advance(edges.step_x, at);
      if (misses) continue;
      const auto tile = static_cast<std::size_t>(row * grid.columns + column);
      RecordChunk& chunk = tiles[tile].tail(pool);
      chunk.records[static_cast<std::size_t>(chunk.size++)] = record;
    }
  }
  return true;
}

}  // namespace kinescope
