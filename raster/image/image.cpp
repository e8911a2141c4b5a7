#include "raster/image/image.h"

template class kinescope::Image<kinescope::Srgb8>;
