#include "raster/binning.h"

#include <algorithm>

namespace kinescope {
namespace {

/// Whether all of a tile's area lies on the outer side of one edge.
bool misses(const SnappedTriangle& t, const PixelRect& tile) {
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    // E grows with x where the edge goes up, and with y where it goes right.
    const std::int64_t x = std::int64_t{t.y[j] < t.y[i] ? tile.x1 : tile.x0} * 256;
    const std::int64_t y = std::int64_t{t.x[j] > t.x[i] ? tile.y1 : tile.y0} * 256;
    if (t.edge(i, x, y) < 0) return true;
  }
  return false;
}

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
  const bool several = column0 != column1 || row0 != row1;
  for (int row = row0; row <= row1; ++row) {
    for (int column = column0; column <= column1; ++column) {
      const int tile = row * grid.columns + column;
      if (several && misses(t, grid.rect(tile))) continue;
      RecordChunk& chunk = tiles[static_cast<std::size_t>(tile)].tail(pool);
      chunk.records[static_cast<std::size_t>(chunk.size++)] = record;
    }
  }
  return true;
}

}  // namespace kinescope
