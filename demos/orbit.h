// An orbit: a camera moved round a point by dragging, and to and fro by the wheel.
#pragma once

#include "demos/demo.h"
#include "engine/camera.h"

namespace kinescope {

struct Orbit {
  float azimuth_rad = 0.6f, elevation_rad = 0.35f;
  float distance = 5;
  float nearest = 1, farthest = 100;
  bool touched = false;  ///< whether the user has taken hold of it

  /// Answers drags with the left button, the wheel and the arrow keys. @return whether it was one
  bool answer(const InputEvent& event);
  bool held() const { return held_; }
  void turn(float azimuth_by_rad) { azimuth_rad += azimuth_by_rad; }
  /// Eye and target of a camera; the rest stays as it is.
  void aim(Camera& camera, glm::vec3 centre) const;

 private:
  bool held_ = false;
  int last_x_ = 0, last_y_ = 0;
};

}  // namespace kinescope
