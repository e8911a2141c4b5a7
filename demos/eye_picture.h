// What an eye at the origin, looking down -z, has on a picture plane before it: by the perspective
// division alone, which knows no front or back, until a near plane clips.
#pragma once

#include "demos/lesson/space_lesson.h"

namespace kinescope {

struct EyePicture {
  static constexpr double kPlane = 2;   ///< the picture plane's distance
  static constexpr double kNear = 0.5;  ///< and the near plane's
  World world;

  /// A point of space in the picture's pane.
  glm::dvec2 place(const glm::dvec3& p) const;
  /// Whole pixels of the picture as the state; of a point in the eye's plane, infinity.
  void step_at(Track& picture, const glm::dvec3& p) const;

  /// Cuts a line to what lies before the near plane; false if nothing does.
  static bool clip(glm::dvec3& a, glm::dvec3& b);
  /// The eye and its picture plane as an observer sees them.
  static void add_camera(Overlay& over, const SpacePane& space, int pane);
};

}  // namespace kinescope
