// The last loop: what becomes of the layers' light on its way out of the glass, and its encoding.
#pragma once

#include <cstdint>

#include "raster/colour/colour.h"

namespace kinescope {

constexpr int kMostLayers = 3;  ///< of phosphor

/// One row of pixels of each layer. The picture is ambient + the sum over layers of
/// (light * mask + glow) * colour.
struct FinishRow {
  int layers = 1;
  const float* light[kMostLayers] = {};
  const std::uint8_t* mask[kMostLayers] = {};        ///< null, of all layers: 1
  const std::uint8_t* mask_below[kMostLayers] = {};  ///< of the row that comes next, or null
  const Srgb8* out_below = nullptr;                  ///< where that goes
  /// Halation's coarse rows above and below, and how much of the lower one; null: none.
  const float* glow_above[kMostLayers] = {};
  const float* glow_below[kMostLayers] = {};
  float glow_share = 0;
  float colour[kMostLayers][3] = {};  ///< linear red, green, blue
  float ambient[3] = {};
};

/// n pixels.
void finish_light(const FinishRow& row, int n, LinearRgb* out);
/// n pixels, clamped and encoded by the sRGB curve within 0.7 codes.
void finish_encoded(const FinishRow& row, int n, Srgb8* out);

}  // namespace kinescope
