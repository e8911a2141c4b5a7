// A test card: grid, circles, colour bars and greys, as monitors were adjusted by.
#pragma once

#include "demos/studio.h"
#include "raster/image/image.h"

namespace kinescope {

/// Any size; finer detail is left out of small ones.
Image<Srgb8> test_card(const Studio& studio, int width, int height);

}  // namespace kinescope
