// A solid for hidden lines: three beams that stand in each other's way.
#pragma once

#include "engine/scene.h"

namespace kinescope {

/// Positions and triangles; each beam 2.2 long.
Mesh three_beams();

}  // namespace kinescope
