// Scenes moved and put together.
#pragma once

#include <vector>

#include "engine/scene.h"

namespace kinescope {

/// The scene below a new node that turns `up` to +y. @pre up is not 0
Scene stand_up(Scene scene, glm::vec3 up);

/// The rotation that stand_up() applies.
glm::mat4 upright_from_model(glm::vec3 up);

/// The scenes along x in their order, each scaled to the same size and set down on one floor, a
/// tenth of that size apart. One scene alone is returned as it is.
Scene side_by_side(std::vector<Scene> scenes);

}  // namespace kinescope
