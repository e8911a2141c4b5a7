// An exposure: the span of time over which light is gathered.
#pragma once

#include "raster/base/units.h"

namespace kinescope {

/// The half-open span [begin, end). Light in [a,c) is the light in [a,b) plus that in [b,c).
struct Exposure {
  Seconds begin{0};
  Seconds end{0};
  constexpr Seconds length() const { return end - begin; }
};

}  // namespace kinescope
