// The circular zone plate. Source: J. O. Drewery, "The zone plate as a television test pattern",
// BBC Research Department report 1978/23.
#include <numbers>

#include "display/patterns/areas.h"
#include "display/patterns/patterns.h"

namespace kinescope {

Image<Srgb8> zone_plate(int width, int height) {
  Image<Srgb8> picture(width, height);
  // A 4:3 face: what is a circle there has this share of x's frequency at the top and bottom.
  const double down_share = 9.0 / 16 * width / height, most = std::max(1.0, down_share);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // From a pixel's own middle: at the sides the finest rings then have black and white pixels.
      const double from_x = x - width / 2, from_y = y - height / 2;
      const double turns = from_x * from_x / width + down_share * from_y * from_y / height;
      picture.at(x, y) = grey_drive(0.5 + 0.5 * std::cos(std::numbers::pi * turns / most));
    }
  }
  return picture;
}

}  // namespace kinescope
