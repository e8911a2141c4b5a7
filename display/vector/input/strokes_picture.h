// A drawing as one sweep of a sharp beam leaves it: what was decoded, without the tube's time.
#pragma once

#include "display/vector/input/drawing.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// The drawing's area as large as it fits into width x height, centred on black. The beam is as
/// wide whatever the pens' widths; where strokes meet, their light adds.
Image<Srgb8> strokes_picture(const VectorDrawing& drawing, int width, int height, Workers& workers);

}  // namespace kinescope
