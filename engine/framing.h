// Automatic framing: a camera and lights that show any model well.
#pragma once

#include "engine/scene.h"

namespace kinescope {

/// Bounds of everything drawn, world space. Vertices that are not finite, or farther out than 1e18,
/// are passed over.
struct Bounds {
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
  bool empty = true;
  glm::vec3 centre() const { return min * 0.5f + max * 0.5f; }
  float radius() const;  ///< of the sphere about the box; 0 if empty
  void add(glm::vec3 point);
  void add(const Bounds& other);
};
Bounds world_bounds(const Scene& scene);

/// The nearest camera that sees the whole scene, with a small margin, from the direction given by
/// two angles, radians: azimuth about the y axis from +z, elevation above the horizon.
Camera frame_scene(const Scene& scene, float aspect, float azimuth_rad = 0.6f,
                   float elevation_rad = 0.35f, float fov_y_rad = 0.7f);

/// The same for a camera that is walked around: as near as the whole scene stays in the picture at
/// every azimuth. look_at lies on the vertical axis through the middle of the scene.
Camera frame_turntable(const Scene& scene, float aspect, float azimuth_rad = 0.6f,
                       float elevation_rad = 0.35f, float fov_y_rad = 0.7f);

/// Key, fill and rim light fitted to the scene's size; used when a model brings none.
void add_default_lights(Scene& scene, const Camera& camera);

}  // namespace kinescope
