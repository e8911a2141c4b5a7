#include "raster/reference_rasterizer.h"

#include <algorithm>

#include "raster/binning.h"
#include "raster/sample_pattern.h"
#include "raster/triangle_setup.h"
#include "raster/visibility_hash.h"

namespace kinescope {
namespace {

bool covers(const SnappedTriangle& t, std::int64_t px, std::int64_t py) {
  for (int i = 0; i < 3; ++i) {
    const std::int64_t e = t.edge(i, px, py);
    if (e < 0 || (e == 0 && !t.is_top_left(i))) return false;
  }
  return true;
}

void draw_triangle(const SnappedTriangle& t, std::uint32_t id,
                   std::span<const SampleOffset> pattern, ReferenceImage& out) {
  const PixelRect box = pixel_box(t, pattern, TileGrid(out.width, out.height, 8, 8));
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      for (std::size_t s = 0; s < pattern.size(); ++s) {
        const SampleOffset o = pattern[s];
        if (!covers(t, std::int64_t{x} * 256 + o.x.raw(), std::int64_t{y} * 256 + o.y.raw())) {
          continue;
        }
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) +
                           static_cast<std::size_t>(x);
        const std::size_t i = pixel * pattern.size() + s;
        const float z = t.depth.at(static_cast<float>(x) + o.x.to_float(),
                                   static_cast<float>(y) + o.y.to_float());
        ++out.coverage[i];
        if (z < out.depth[i] || (z == out.depth[i] && id < out.id[i])) {
          out.depth[i] = z;
          out.id[i] = id;
        }
      }
    }
  }
}

}  // namespace

ReferenceImage draw_reference(int width, int height, int samples, std::span<const DrawCall> calls) {
  const std::span<const SampleOffset> pattern = sample_pattern(samples);
  ReferenceImage out;
  out.width = width;
  out.height = height;
  out.samples = samples;
  const std::size_t total = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                            static_cast<std::size_t>(samples);
  out.coverage.assign(total, 0);
  out.depth.assign(total, 1.0f);
  out.id.assign(total, ReferenceImage::kNothing);
  std::uint32_t id = 0;
  for (const DrawCall& call : calls) {
    for (std::size_t i = 0; i < call.indices.size() / 3; ++i, ++id) {
      SnappedTriangle triangle;
      if (set_up_triangle(call, i, triangle)) draw_triangle(triangle, id, pattern, out);
    }
  }
  for (std::size_t i = 0; i < total; ++i) {
    out.visibility_hash += sample_hash(i, out.id[i], out.depth[i]);
  }
  return out;
}

}  // namespace kinescope
