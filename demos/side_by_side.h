// Several models in one scene.
#pragma once

#include <vector>

#include "engine/scene.h"

namespace kinescope {

/// The scenes along x in their order, each scaled to the same size and set down on one floor, a
/// tenth of that size apart. One scene alone is returned as it is.
Scene side_by_side(std::vector<Scene> scenes);

}  // namespace kinescope
