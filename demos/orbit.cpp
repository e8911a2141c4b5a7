#include "demos/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kinescope {
namespace {

constexpr float kRadPerPixel = 0.006f, kRadPerKey = 0.09f, kZoomPerNotch = 1.1f;
constexpr float kSteepest = 0.49f * std::numbers::pi_v<float>;

}  // namespace

bool Orbit::answer(const InputEvent& event) {
  const auto swing = [&](float right_rad, float up_rad) {
    azimuth_rad -= right_rad;
    elevation_rad = std::clamp(elevation_rad + up_rad, -kSteepest, kSteepest);
    return touched = true;
  };
  switch (event.kind) {
    case InputKind::kMouseDown:
      held_ = event.button == MouseButton::kLeft;
      last_x_ = event.x;
      last_y_ = event.y;
      return held_;
    case InputKind::kMouseUp:
      return std::exchange(held_, false);
    case InputKind::kMouseMove: {
      if (!held_) return false;
      const int dx = event.x - last_x_, dy = event.y - last_y_;
      last_x_ = event.x;
      last_y_ = event.y;
      return swing(static_cast<float>(dx) * kRadPerPixel, static_cast<float>(dy) * kRadPerPixel);
    }
    case InputKind::kWheel:
      distance = std::clamp(distance * std::pow(kZoomPerNotch, -event.wheel), nearest, farthest);
      return touched = true;
    case InputKind::kKeyDown:
      if (event.key == "Left") return swing(-kRadPerKey, 0);
      if (event.key == "Right") return swing(kRadPerKey, 0);
      if (event.key == "Up") return swing(0, kRadPerKey);
      if (event.key == "Down") return swing(0, -kRadPerKey);
      return false;
    default:
      return false;
  }
}

void Orbit::aim(Camera& camera, glm::vec3 centre) const {
  const float flat = std::cos(elevation_rad);
  camera.look_at = centre;
  camera.eye = centre + distance * glm::vec3(flat * std::sin(azimuth_rad), std::sin(elevation_rad),
                                             flat * std::cos(azimuth_rad));
}

}  // namespace kinescope
