// Whether two targets hold the same picture and depth, bit by bit but for the kinds of NaN.
#pragma once

#include "raster/render_target.h"

namespace kinescope::soak {

bool same_picture(const RenderTarget& a, const RenderTarget& b);

}  // namespace kinescope::soak
