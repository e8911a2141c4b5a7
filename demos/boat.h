// A boat on the sea: shapes with a colour that changes from left to right, as data and as light.
#pragma once

#include <array>

#include "raster/colour/colour.h"
#include "raster/fill/polygon.h"
#include "raster/image/image.h"

namespace kinescope {

/// Corners in shares of the picture, and its colours at the left and right.
struct BoatPart {
  Contour corners;
  LinearRgb left, right;
};
const std::array<BoatPart, 4>& boat();

/// Each pixel by the exact area that the parts cover of it.
Image<LinearRgb> boat_picture(int width, int height);

}  // namespace kinescope
