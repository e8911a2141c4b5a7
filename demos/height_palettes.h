// Colours of a landscape's heights, which lie about 0: plasma, clouds, flames, and a map.
#pragma once

#include "raster/colour/colour.h"

namespace kinescope {

enum class HeightPalette { kPlasma, kClouds, kFlames, kMap };

/// Of a map, heights below 0 are the sea.
Srgb8 height_colour(HeightPalette palette, double height);

}  // namespace kinescope
