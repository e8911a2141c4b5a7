// Pictures of one channel, which ditherers take.
#pragma once

#include <cstdint>

#include "raster/image/image.h"

namespace kinescope {

/// Codes 0 to 255. For the light of the dots to add up to the picture's they must be linear; dots
/// made from encoded values come out too bright, as in most programs.
using GreyImage = Image<std::uint8_t>;

}  // namespace kinescope
