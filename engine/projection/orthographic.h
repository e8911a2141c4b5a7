// The orthographic views of engineering drawing: front, top and side, each along an axis.
// Source: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and Practice", 1990,
// ch. 6.1.
#pragma once

#include <glm/mat4x4.hpp>

namespace kinescope {

enum class OrthographicView {
  kFront,  ///< from +z: x to the right, y up
  kTop,    ///< from +y: x to the right, -z up
  kSide,   ///< from +x: -z to the right, y up
};

/// Picture space: x right, y up, z towards the viewer; the picture is x and y. True lengths in two
/// axes, nothing of the third.
glm::dmat4 picture_from_world(OrthographicView view);

}  // namespace kinescope
