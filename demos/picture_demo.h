// The user's own picture on a tube, in a window.
#pragma once

#include "demos/demo.h"
#include "display/raster_tube.h"

namespace kinescope {

/// @param drive of the guns, of the mode's size
DemoInfo picture_demo(const TubeSettings& tube, Image<Srgb8> drive);

}  // namespace kinescope
