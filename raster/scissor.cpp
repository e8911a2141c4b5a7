#include "raster/scissor.h"

#include <algorithm>

namespace kinescope {
namespace {

void move_triangle(std::size_t from, std::size_t to, CulledTriangles::Snapped& t) {
  for (std::size_t v = 0; v < 3; ++v) {
    t.x[v][to] = t.x[v][from];
    t.y[v][to] = t.y[v][from];
    t.z[v][to] = t.z[v][from];
  }
  t.triangle[to] = t.triangle[from];
}

void sort_out(const PixelRect& clip, const SampleLimits& limits, CulledTriangles::Snapped& t,
              CulledTriangles& all) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(t.size); ++i) {
    const auto [x_min, x_max] = std::minmax({t.x[0][i], t.x[1][i], t.x[2][i]});
    const auto [y_min, y_max] = std::minmax({t.y[0][i], t.y[1][i], t.y[2][i]});
    // The pixels that have a sample in the box.
    const PixelRect box = {
        (x_min - limits.most_x.raw() + 255) >> 8, (y_min - limits.most_y.raw() + 255) >> 8,
        ((x_max - limits.least_x.raw()) >> 8) + 1, ((y_max - limits.least_y.raw()) >> 8) + 1};
    if (intersection(box, clip).empty()) continue;
    if (clip.contains(box)) {
      move_triangle(i, kept++, t);
    } else {
      all.large_triangle[static_cast<std::size_t>(all.large_size++)] = t.triangle[i];
    }
  }
  t.size = static_cast<int>(kept);
}

}  // namespace

PixelRect clip_of(const DrawCall& call, const TileGrid& grid) {
  const PixelRect target = {0, 0, grid.width, grid.height};
  return call.scissor ? intersection(*call.scissor, target) : target;
}

void apply_scissor(const PixelRect& clip, std::span<const SampleOffset> pattern,
                   CulledTriangles& triangles) {
  const SampleLimits limits = sample_limits(pattern);
  sort_out(clip, limits, triangles.small, triangles);
  sort_out(clip, limits, triangles.medium, triangles);
}

}  // namespace kinescope
