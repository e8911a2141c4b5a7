// The four steps of the viewing transformation, one by one: their product is what a camera does at
// once, up to the scale of depth.
// Source: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and Practice", 1990,
// ch. 6.5.
#pragma once

#include <vector>

#include "engine/camera.h"
#include "engine/transform/transform3d.h"

namespace kinescope {

/// Eye to the origin; line of sight onto -z and up onto y; the window's middle onto the z axis (a
/// shear for perspective, as the window need not be square to it; a shift for parallel views);
/// scaling to the canonical volume. That is |x|, |y| <= -z <= 1 for perspective, and |x|, |y| <= 1,
/// 0 <= -z <= 1 with 0 at the eye for parallel views. Far planes at infinity leave depth unscaled.
/// @throws Error (bad input) if the window, view distance or far plane has no size
std::vector<TransformStep3> viewing_steps(const Camera& camera);

}  // namespace kinescope
