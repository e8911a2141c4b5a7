// Rows of linear light to 8 bits a channel without a curve.
#pragma once

#include <span>

#include "raster/colour/colour.h"

namespace kinescope {

/// Rounds in.size() pixels to nearest; values are clamped to [0, 1], NaN gives 0.
void quantize_row(std::span<const LinearRgba> in, std::span<Linear8> out);

/// The same for 8x8 pixels.
/// @param stride  pixels from row to row of the output
void quantize_block(std::span<const LinearRgba, 64> in, Linear8* out, std::size_t stride);

}  // namespace kinescope
