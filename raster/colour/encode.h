// Rows of linear light to sRGB codes, in SIMD.
#pragma once

#include <span>

#include "raster/colour/colour.h"

namespace kinescope {

/// Each writes in.size() pixels; `out` is at least as long. Values are clamped, NaN gives 0.
/// To 8 bits: exactly encode_srgb8() of each pixel. To 16 bits: within one code of
/// encode_srgb16().
void encode_row(std::span<const LinearRgba> in, std::span<Srgb8> out);
void encode_row(std::span<const LinearRgb> in, std::span<Srgb8> out);
void encode_row(std::span<const LinearRgb> in, std::span<Srgb16> out);

}  // namespace kinescope
