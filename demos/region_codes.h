// The nine regions about a window, each named by its code.
#pragma once

#include <string>

#include "demos/lesson/lesson.h"
#include "engine/clip/outcode.h"

namespace kinescope {

/// Four bits: above, below, right, left.
std::string code_bits(Outcode code);

/// A label in the upper left of each region that the pane shows enough of.
Overlay region_codes(const World& world, const ClipWindow& window);

}  // namespace kinescope
