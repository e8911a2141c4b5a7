// Rows of linear light to 8 bits a channel without a curve.
#pragma once

#include <span>

#include "raster/colour/colour.h"

namespace kinescope {

/// Rounds in.size() pixels to nearest; values are clamped to [0, 1], NaN gives 0.
void quantize_row(std::span<const LinearRgba> in, std::span<Linear8> out);

}  // namespace kinescope
