// The rasterizer's law, as simple as it can be said: what every fast path must equal bit by bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/draw_call.h"

namespace kinescope {

/// Samples in the order (y * width + x) * samples + s.
struct ReferenceImage {
  int width = 0, height = 0, samples = 1;
  std::vector<std::uint32_t> coverage;  ///< how many triangles cover the sample
  std::vector<float> depth;             ///< 1 where nothing is visible
  std::vector<std::uint32_t> id;        ///< visible triangle, by order of submission
  std::uint64_t visibility_hash = 0;    ///< as Rasterizer::draw gives it

  static constexpr std::uint32_t kNothing = 0xffffffffu;
};

/// Draws by testing every sample in the box of each triangle against its edges.
/// @param samples 1, 4 or 8
ReferenceImage draw_reference(int width, int height, int samples, std::span<const DrawCall> calls);

}  // namespace kinescope
