#include "demos/eye_picture.h"

#include <array>
#include <cmath>

namespace kinescope {

glm::dvec2 EyePicture::place(const glm::dvec3& p) const {
  const double scale = 0.3 * world.columns(), share = kPlane / -p.z;
  return {0.5 * world.columns() + scale * share * p.x, 0.5 * world.rows() - scale * share * p.y};
}

void EyePicture::step_at(Track& picture, const glm::dvec3& p) const {
  const glm::dvec2 at = p.z == 0 ? glm::dvec2(HUGE_VAL) : glm::round(place(p));
  picture.step({at.x, at.y});
}

bool EyePicture::clip(glm::dvec3& a, glm::dvec3& b) {
  const double a_by = -a.z - kNear, b_by = -b.z - kNear;
  if (a_by < 0 && b_by < 0) return false;
  const glm::dvec3 crossing = a_by == b_by ? a : a + a_by / (a_by - b_by) * (b - a);
  if (a_by < 0) a = crossing;
  if (b_by < 0) b = crossing;
  return true;
}

void EyePicture::add_camera(Overlay& over, const SpacePane& space, int pane) {
  const std::array<glm::dvec3, 4> c = {
      {{-1.6, -1.6, -kPlane}, {1.6, -1.6, -kPlane}, {1.6, 1.6, -kPlane}, {-1.6, 1.6, -kPlane}}};
  for (std::size_t i = 0; i < 4; ++i) {
    space.add_line(over, c[i], c[(i + 1) % 4], theme::kCool, pane);
  }
  space.add_label(over, {0, 0, 0}, "eye", theme::kCool, pane);
  space.add_label(over, {0, 1.9, -kPlane}, "picture", theme::kCool, pane);
}

}  // namespace kinescope
