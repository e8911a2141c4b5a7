// Lays the gathered rows of a polygon on a picture, in SIMD.
#pragma once

#include "raster/image/image.h"
#include "raster/path/exact_area.h"
#include "raster/path/ink.h"

namespace kinescope {

/// Lays ink on the pixels that `area` covers, its corner at (x, y) of the picture, within which it
/// must lie; exactly as ExactArea::rows() and ink::lay() do. The area is empty afterwards.
void fill_area(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
               Image<Linear8>& picture);
void fill_area(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
               Image<LinearRgba>& picture);

}  // namespace kinescope
