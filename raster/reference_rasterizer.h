// The rasterizer's law, as simple as it can be said: what every fast path must equal bit by bit.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "raster/colour/colour.h"
#include "raster/draw_call.h"

namespace kinescope {

/// Samples in the order (y * width + x) * samples + s.
struct ReferenceImage {
  int width = 0, height = 0, samples = 1;
  std::vector<std::uint32_t> coverage;  ///< how many triangles cover the sample
  std::vector<float> depth;             ///< 1 where none was written
  std::vector<std::uint32_t> id;        ///< triangle that wrote it, by order of submission
  std::uint64_t visibility_hash = 0;    ///< as Rasterizer::draw gives it
  std::vector<LinearRgba> colour;       ///< filled by draw_reference_colours

  static constexpr std::uint32_t kNothing = 0xffffffffu;
  /// What a sample without depth counts as.
  static constexpr float kBeyond = std::numeric_limits<float>::infinity();

  std::size_t index(int x, int y, std::size_t sample) const {
    const auto pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    return pixel * static_cast<std::size_t>(samples) + sample;
  }
};

/// Draws by testing every sample in the box of each triangle against its edges, one triangle after
/// another.
/// @param samples 1, 4 or 8
ReferenceImage draw_reference(int width, int height, int samples, std::span<const DrawCall> calls);

/// The same with colours. Shaders get one fragment at a time, and no gradients: attributes agree
/// with Rasterizer's to rounding.
ReferenceImage draw_reference_colours(int width, int height, int samples,
                                      std::span<const DrawCall> calls, const LinearRgba& clear);

}  // namespace kinescope
