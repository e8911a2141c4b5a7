// From the light of a faceplate's phosphor layers to colour.
#pragma once

#include <array>

#include "display/phosphor.h"

namespace kinescope {

/// Each layer's linear sRGB at full drive: three layers make white (1, 1, 1) together; those of a
/// monochrome type have the hue of their mixture, its largest channel at 1. Layers that the type
/// lacks are black.
std::array<std::array<float, 3>, 3> layer_colours(const PhosphorType& type);

}  // namespace kinescope
