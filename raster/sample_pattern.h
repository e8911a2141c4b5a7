// Where in a pixel its coverage samples lie.
#pragma once

#include <cstdint>
#include <span>

#include "raster/base/fixed.h"

namespace kinescope {

/// A sample's place, from the pixel's top left corner.
struct SampleOffset {
  Fixed24_8 x;
  Fixed24_8 y;
};

/// The least and most of a pattern's places.
struct SampleLimits {
  Fixed24_8 least_x, most_x, least_y, most_y;
};
SampleLimits sample_limits(std::span<const SampleOffset> pattern);

/// The standard patterns of 1, 4 and 8 samples.
/// Source: Vulkan specification, "Standard sample locations" (the same as Direct3D 11's).
/// @throws Error (usage) for any other count
std::span<const SampleOffset> sample_pattern(int samples);

}  // namespace kinescope
