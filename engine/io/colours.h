// Colours as model files write them.
#pragma once

#include <glm/vec3.hpp>

#include "engine/io/text.h"
#include "raster/colour/colour.h"

namespace kinescope {

/// Formats that do not say so mean their colours as they look on a screen: sRGB.
inline glm::vec3 linear_from_srgb(double r, double g, double b) {
  return {srgb_decode(to_float(r)), srgb_decode(to_float(g)), srgb_decode(to_float(b))};
}

}  // namespace kinescope
