#include "raster/scan/limits.h"

#include <fmt/format.h>

#include "raster/base/error.h"

namespace kinescope {

void check_coordinates(glm::ivec2 p) {
  if (is_drawable(p)) return;
  throw_bad_input(fmt::format("point ({}, {}) lies beyond {}", p.x, p.y, kLargestCoordinate));
}

void check_round(glm::ivec2 centre, int radius, int largest) {
  check_coordinates(centre);
  if (radius > largest) {
    throw_bad_input(fmt::format("radius {} is larger than {}", radius, largest));
  }
}

}  // namespace kinescope
