// A drawing as plain anti-aliased lines: what was decoded, without any tube.
#pragma once

#include "display/vector/input/drawing.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// The drawing's area as large as it fits into width x height, centred on black; strokes add their
/// light and are at least a pixel wide.
Image<Srgb8> strokes_picture(const VectorDrawing& drawing, int width, int height, Workers& workers);

}  // namespace kinescope
