// Pictures made by formula, for tests, benches and demos that need no file.
#pragma once

#include "raster/image/image.h"

namespace kinescope {

/// A checkerboard of light and mid grey. In each corner two by two of its cells have a colour of
/// their own, so that a turned or mirrored picture shows: top left red, top right green, bottom
/// left blue, bottom right yellow.
/// @param cells how many cells a side, at least 4
Image<Srgb8> labelled_checkerboard(int width = 1024, int height = 1024, int cells = 16);

}  // namespace kinescope
