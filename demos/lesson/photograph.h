// A photograph for lessons that work on pictures: a still life that our own renderer takes.
#pragma once

#include "raster/base/workers.h"
#include "raster/dither/grey.h"
#include "raster/image/image.h"

namespace kinescope {

/// The teapot on a table before a wall, in daylight and lamplight.
Image<Srgb8> photograph(Workers& workers, int width, int height);

/// A lit ball over a slope of greys.
Image<Srgb8> lit_ball(int width, int height);

/// Its encoded codes of grey; `linear`: its light instead, for ditherers.
GreyImage grey_of(const Image<Srgb8>& picture, bool linear);

}  // namespace kinescope
