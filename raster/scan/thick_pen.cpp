#include "raster/scan/thick_pen.h"

#include <cmath>

namespace kinescope {

// An even pen has no middle pixel: its own pixel is the one above and left of the middle.
Pen Pen::round(int diameter) {
  Pen pen;
  const int low = -((diameter - 1) / 2), high = diameter / 2;
  for (int y = low; y <= high && diameter > 0; ++y) {
    // Doubled distances from the middle, which may lie between pixels.
    const double v = 2.0 * y - (low + high), r = diameter;
    const double half = std::sqrt(r * r - v * v);
    const auto begin = static_cast<int>(std::ceil((low + high - half) / 2));
    const auto end = static_cast<int>(std::floor((low + high + half) / 2)) + 1;
    pen.rows.push_back({y, begin, end});
  }
  return pen;
}

Pen Pen::square(int side) {
  Pen pen;
  const int low = -((side - 1) / 2), high = side / 2;
  for (int y = low; y <= high && side > 0; ++y) pen.rows.push_back({y, low, high + 1});
  return pen;
}

}  // namespace kinescope
