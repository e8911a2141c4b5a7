// A camera: where it stands, and how its view window is laid.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kinescope {

enum class Projection { kPerspective, kOrthographic };

/// Eye, target and up in world space, and a view window at view_distance in front of the eye,
/// whose corners are given in view space (x right, y up): it need not be centred on the view axis.
struct Camera {
  glm::vec3 eye{0.0f, 0.0f, 5.0f};
  glm::vec3 look_at{0.0f};
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  Projection projection = Projection::kPerspective;
  float view_distance = 1.0f;
  glm::vec2 window_min{-1.0f, -1.0f};
  glm::vec2 window_max{1.0f, 1.0f};
  float near_plane = 0.1f;
  float far_plane = 1000.0f;

  /// A window centred on the view axis: vertical field of view in radians, width over height.
  void set_field_of_view(float fov_y_rad, float aspect);
  /// Widens the window about its centre to the given width over height, keeping its height.
  void set_aspect(float aspect);

  glm::mat4 view_from_world() const;
  /// Clip space: -w <= x, y <= w, 0 <= z <= w, y up, z 0 at the near plane.
  glm::mat4 clip_from_view() const;
  glm::mat4 clip_from_world() const { return clip_from_view() * view_from_world(); }
};

/// A rectangle of the device, pixels, y down.
struct Viewport {
  float x = 0, y = 0, width = 1, height = 1;
};

/// Window-to-viewport mapping of normalized device coordinates: device = ndc * scale + offset.
struct ViewportTransform {
  glm::vec2 scale;
  glm::vec2 offset;
};
ViewportTransform device_from_ndc(const Viewport& viewport);

}  // namespace kinescope
