// Which samples a triangle covers, as simple as it can be said.
#pragma once

#include <cstdint>
#include <span>

#include "raster/binning.h"
#include "raster/sample_pattern.h"
#include "raster/triangle_setup.h"

namespace kinescope {

/// px and py in raw Fixed24_8.
inline bool covers(const SnappedTriangle& t, std::int64_t px, std::int64_t py) {
  for (int i = 0; i < 3; ++i) {
    const std::int64_t e = t.edge(i, px, py);
    if (e < 0 || (e == 0 && !t.is_top_left(i))) return false;
  }
  return true;
}

/// Calls each(x, y, sample, depth) for every sample of the grid's target that one triangle of a
/// call covers within the call's scissor, row by row.
template <typename Each>
void for_each_sample(const DrawCall& call, const SnappedTriangle& t,
                     std::span<const SampleOffset> pattern, const TileGrid& grid,
                     const Each& each) {
  PixelRect box = pixel_box(t, pattern, grid);
  if (call.scissor) box = intersection(box, *call.scissor);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      for (std::size_t s = 0; s < pattern.size(); ++s) {
        const SampleOffset o = pattern[s];
        if (!covers(t, std::int64_t{x} * 256 + o.x.raw(), std::int64_t{y} * 256 + o.y.raw())) {
          continue;
        }
        each(x, y, s,
             t.depth.at(static_cast<float>(x) + o.x.to_float(),
                        static_cast<float>(y) + o.y.to_float()));
      }
    }
  }
}

}  // namespace kinescope
