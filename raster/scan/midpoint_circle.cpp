#include "raster/scan/midpoint_circle.h"

#include <algorithm>

namespace kinescope {

std::int64_t MidpointCircle::height(std::int64_t x) const {
  // The largest y whose midpoint below, y - 1/2, is inside: x^2 + y^2 - y < r^2.
  const std::int64_t rest = (radius_ - x) * (radius_ + x);
  if (rest <= 0) return 0;
  auto y = static_cast<std::int64_t>(std::sqrt(static_cast<double>(rest)));
  while (y > 0 && y * y - y >= rest) --y;
  while ((y + 1) * (y + 1) - (y + 1) < rest) ++y;
  return y;
}

void MidpointCircle::skip_to(int x) {
  x_ = x;
  y_ = x == 0 ? radius_ : height(x);
  decision_ = (x_ + 1) * (x_ + 1) - (radius_ - y_) * (radius_ + y_) - y_;
}

namespace {

/// The first column of [0, end) for which `is_past` holds, which it then does for all behind it.
template <typename IsPast>
int first_column(int end, IsPast&& is_past) {
  int begin = 0;
  while (begin < end) {
    const int middle = begin + (end - begin) / 2;
    if (is_past(middle)) {
      end = middle;
    } else {
      begin = middle + 1;
    }
  }
  return begin;
}

}  // namespace

OctantRange octant_within(glm::ivec2 centre, int radius, int octant, const PixelRect& window) {
  if (radius < 0 || window.empty()) return {};
  const MidpointCircle circle(radius);
  // Distances from the centre that the window leaves to each axis of the pixel.
  struct Reach {
    std::int64_t low, high;
  };
  const auto reach = [](std::int64_t low, std::int64_t high, std::int64_t at, bool mirrored) {
    return mirrored ? Reach{at - high, at - low} : Reach{low - at, high - at};
  };
  const Reach in_x = reach(window.x0, window.x1 - 1, centre.x, octant & 1);
  const Reach in_y = reach(window.y0, window.y1 - 1, centre.y, octant & 2);
  const Reach along = octant & 4 ? in_y : in_x, across = octant & 4 ? in_x : in_y;
  const int columns = first_column(radius + 1, [&](int x) { return x > circle.height(x); });
  // Heights fall from column to column.
  const int first = first_column(columns, [&](int x) { return circle.height(x) <= across.high; });
  const int past = first_column(columns, [&](int x) { return circle.height(x) < across.low; });
  const auto column = [&](std::int64_t x) {
    return static_cast<int>(std::clamp<std::int64_t>(x, 0, columns));
  };
  return {std::max(first, column(along.low)), std::min(past, column(along.high + 1))};
}

}  // namespace kinescope
