#include "engine/projection/window_to_viewport.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "raster/base/error.h"

namespace kinescope {

std::vector<TransformStep2> window_to_viewport_steps(const Window& window, const Window& viewport) {
  const glm::dvec2 size = window.high - window.low;
  const bool whole = std::isfinite(size.x) && std::isfinite(size.y);
  if (!whole || size.x == 0.0 || size.y == 0.0) {
    throw_bad_input("a window has a width and a height");
  }
  return {{"window's corner to the origin", translation(-window.low)},
          {"window's size to the viewport's", scaling((viewport.high - viewport.low) / size)},
          {"to the viewport's corner", translation(viewport.low)}};
}

glm::dmat3 viewport_from_window(const Window& window, const Window& viewport) {
  return compose(window_to_viewport_steps(window, viewport));
}

Window of_same_shape(const Window& window, const Window& viewport) {
  const glm::dvec2 size = viewport.high - viewport.low, shape = glm::abs(window.high - window.low);
  const glm::dvec2 scale = glm::abs(size) / shape;
  return {viewport.low, viewport.low + glm::sign(size) * std::min(scale.x, scale.y) * shape};
}

}  // namespace kinescope
