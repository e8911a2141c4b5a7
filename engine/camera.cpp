#include "engine/camera.h"

namespace kinescope {

ViewportTransform device_from_ndc(const Viewport& viewport) {
  const glm::vec2 half(viewport.width * 0.5f, viewport.height * 0.5f);
  return {{half.x, -half.y}, {viewport.x + half.x, viewport.y + half.y}};
}

}  // namespace kinescope
