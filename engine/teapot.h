// The Utah teapot (Newell 1975) from its 32 bicubic Bezier patches.
#pragma once

#include "engine/scene.h"

namespace kinescope {

/// @param fineness quads along each side of a patch, at least 1; triangles = 64 fineness^2, less
///                 those that the lid's and the bottom's poles make degenerate
/// Stands on y = 0, about 3.15 high, spout towards +x, y up.
Mesh teapot_mesh(int fineness);

}  // namespace kinescope
