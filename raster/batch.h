// What the rasterizer hands to a shader: visible fragments of one surface, structure of arrays.
#pragma once

#include <array>
#include <cstdint>

#include "raster/colour/colour.h"

namespace kinescope {

/// Up to kMaxSize visible fragments of one draw call. Every array is 64-byte aligned and padded:
/// a shader may read and write whole vectors past `size`, up to kMaxSize.
struct Batch {
  static constexpr int kMaxSize = 256;
  static constexpr int kMaxAttributes = 16;

  int size = 0;                              ///< fragments, 1 to kMaxSize
  const void* constants = nullptr;           ///< what the draw call carried: material, lights
  const std::uint16_t* x = nullptr;          ///< pixel column of each fragment
  const std::uint16_t* y = nullptr;          ///< pixel row of each fragment, from the top
  const std::uint32_t* primitive = nullptr;  ///< the fragment's source triangle in its draw call
  /// 1 where the triangle's front is seen, -1 where its back is; null where culling leaves one
  /// side.
  const float* facing = nullptr;
  /// Perspective-correct attributes at the pixel's centre, in the order of the vertex rows; of
  /// those that DrawCall::attributes_read names.
  std::array<const float*, kMaxAttributes> attribute{};
  /// Texture-coordinate gradients, a pixel to the right and a pixel down; null unless the draw call
  /// names its texture coordinates (DrawCall::texcoord_attribute).
  const float* du_dx = nullptr;
  const float* dv_dx = nullptr;
  const float* du_dy = nullptr;
  const float* dv_dy = nullptr;
};

/// A shader: writes batch.size linear colours. A plain function, called once a batch.
using ShadeFunction = void (*)(const Batch& batch, LinearRgba* out);

}  // namespace kinescope
