#include "raster/sample_pattern.h"

#include <algorithm>
#include <array>
#include <string>

#include "raster/base/error.h"

namespace kinescope {
namespace {

/// From sixteenths of a pixel right of and below the pixel's centre.
constexpr SampleOffset from_centre(int x_16ths, int y_16ths) {
  return {Fixed24_8::from_raw(128 + 16 * x_16ths), Fixed24_8::from_raw(128 + 16 * y_16ths)};
}

constexpr std::array kCentre = {from_centre(0, 0)};
constexpr std::array kFour = {from_centre(-2, -6), from_centre(6, -2), from_centre(-6, 2),
                              from_centre(2, 6)};
constexpr std::array kEight = {from_centre(1, -3),  from_centre(-1, 3), from_centre(5, 1),
                               from_centre(-3, -5), from_centre(-5, 5), from_centre(-7, -1),
                               from_centre(3, 7),   from_centre(7, -7)};

}  // namespace

std::span<const SampleOffset> sample_pattern(int samples) {
  switch (samples) {
    case 1:
      return kCentre;
    case 4:
      return kFour;
    case 8:
      return kEight;
    default:
      throw Error(ErrorKind::kUsage,
                  "a pixel has 1, 4 or 8 samples, not " + std::to_string(samples));
  }
}

SampleLimits sample_limits(std::span<const SampleOffset> pattern) {
  SampleLimits out = {pattern[0].x, pattern[0].x, pattern[0].y, pattern[0].y};
  for (const SampleOffset& o : pattern) {
    out = {std::min(out.least_x, o.x), std::max(out.most_x, o.x), std::min(out.least_y, o.y),
           std::max(out.most_y, o.y)};
  }
  return out;
}

}  // namespace kinescope
