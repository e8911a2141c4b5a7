#include "raster/reference_rasterizer.h"

#include "raster/reference_coverage.h"
#include "raster/visibility_hash.h"

namespace kinescope {
namespace {

void test_depth(const DrawCall& call, float z, std::uint32_t id, float& depth,
                std::uint32_t& writer) {
  const float stored = writer == ReferenceImage::kNothing ? ReferenceImage::kBeyond : depth;
  const bool writes = call.depth_write && call.order == BlendOrder::kSubmitted;
  if (!writes || !passes(call.depth_test, z, stored)) return;
  depth = z;
  writer = id;
}

}  // namespace

ReferenceImage draw_reference(int width, int height, int samples, std::span<const DrawCall> calls) {
  const std::span<const SampleOffset> pattern = sample_pattern(samples);
  const TileGrid grid(width, height, 8, 8);
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
      if (!set_up_triangle(call, i, triangle)) continue;
      for_each_sample(call, triangle, pattern, grid, [&](int x, int y, std::size_t s, float z) {
        const std::size_t at = out.index(x, y, s);
        ++out.coverage[at];
        test_depth(call, z, id, out.depth[at], out.id[at]);
      });
    }
  }
  for (std::size_t i = 0; i < total; ++i) {
    out.visibility_hash += sample_hash(i, out.id[i], out.depth[i]);
  }
  return out;
}

}  // namespace kinescope
