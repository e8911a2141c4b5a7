// Thresholding at one and at several levels.
// Source: D. Hearn and M. P. Baker, "Computer Graphics", 1986.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "raster/image/image.h"

namespace kinescope {

/// How many of the ascending thresholds a value exceeds: the level that it gets.
template <typename Value>
int level_of(Value value, std::span<const Value> thresholds) {
  return static_cast<int>(std::lower_bound(thresholds.begin(), thresholds.end(), value) -
                          thresholds.begin());
}

/// Thresholds halfway between `levels` evenly spaced values of 0 to `highest`.
inline std::vector<std::uint8_t> even_thresholds(int levels, int highest = 255) {
  std::vector<std::uint8_t> thresholds;
  for (int i = 0; i + 1 < levels; ++i) {
    thresholds.push_back(static_cast<std::uint8_t>((2 * i + 1) * highest / (2 * (levels - 1))));
  }
  return thresholds;
}

/// Calls sink(x, y, level) for each pixel. One threshold gives levels 0 and 1: above it, 1.
template <typename Value, typename Sink>
void threshold(const Image<Value>& image, std::span<const Value> thresholds, Sink&& sink) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sink(x, y, level_of(image.at(x, y), thresholds));
  }
}

}  // namespace kinescope
