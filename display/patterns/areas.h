// Rectangles by their share of the picture, so that neighbours meet whatever its size.
#pragma once

#include <algorithm>
#include <cmath>

#include "raster/image/draw.h"
#include "raster/image/image.h"

namespace kinescope {

/// A drive of 0 to 1 as a code; what lies outside is cut off, as a gun's signal is.
inline std::uint8_t drive_code(double drive) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(drive, 0.0, 1.0)));
}

inline Srgb8 grey_drive(double drive) {
  const std::uint8_t code = drive_code(drive);
  return {code, code, code, 255};
}

/// Left, top, right, bottom, each 0 to 1.
struct Area {
  double left, top, right, bottom;
};

inline void fill_area(Image<Srgb8>& picture, const Area& area, Srgb8 colour) {
  const auto across = [&](double share) {
    return static_cast<int>(std::lround(share * picture.width()));
  };
  const auto down = [&](double share) {
    return static_cast<int>(std::lround(share * picture.height()));
  };
  const int x = across(area.left), y = down(area.top);
  fill_rect(picture, {x, y, across(area.right) - x, down(area.bottom) - y}, colour);
}

}  // namespace kinescope
