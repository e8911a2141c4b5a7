// What the rasterizer writes: colour in one of three formats, and depth.
#pragma once

#include <cstdint>
#include <variant>

#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

enum class ColourFormat { kSrgb8, kLinear8, kLinearFloat };

/// Colour and depth of one picture. Samples are resolved in linear light as each tile ends.
struct RenderTarget {
  static constexpr int kMaxSize = 16384;  ///< pixels, either way

  RenderTarget() = default;
  /// @param samples 1, 4 or 8 coverage samples a pixel
  /// @throws Error (usage) for a size or sample count out of range, or more memory than there is
  RenderTarget(int width, int height, int samples = 1, ColourFormat format = ColourFormat::kSrgb8);

  int width = 0;
  int height = 0;
  int samples = 1;
  LinearRgba clear{0, 0, 0, 1};
  std::variant<Image<Srgb8>, Image<Linear8>, Image<LinearRgba>> colour;
  /// Depth of sample 0, 1 where nothing was drawn. Filled only if wanted.
  bool keep_depth = false;
  Image<float> depth;

  const Image<Srgb8>& srgb8() const { return std::get<Image<Srgb8>>(colour); }
};

}  // namespace kinescope
