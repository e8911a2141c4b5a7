// Window to viewport: a rectangle of the world onto a rectangle of the device, in three steps. The
// renderer's own, from normalized coordinates, is device_from_ndc.
// Source: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and Practice", 1990,
// ch. 5.5.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/transform/transform2d.h"

namespace kinescope {

/// `low` is carried to `low`, `high` to `high`: for a device with y down, give its viewport with
/// low.y below high.y on the screen, that is, the greater number.
struct Window {
  glm::dvec2 low{0.0}, high{1.0};
};

/// Window's corner to the origin, scaling, to the viewport's corner.
/// @throws Error (bad input) if the window has no width or no height
std::vector<TransformStep2> window_to_viewport_steps(const Window& window, const Window& viewport);
glm::dmat3 viewport_from_window(const Window& window, const Window& viewport);

/// The largest part of the viewport, from its low corner, that has the window's shape: the larger
/// of the two scales is lowered.
Window of_same_shape(const Window& window, const Window& viewport);

}  // namespace kinescope
