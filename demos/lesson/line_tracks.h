// The courses of line algorithms, for the demos that compare them.
#pragma once

#include "demos/lesson/track.h"
#include "raster/scan/bresenham_steps.h"
#include "raster/scan/dda_line.h"

namespace kinescope {

/// @throws Error (bad input) beyond what can be drawn
inline Track dda_track(glm::ivec2 from, glm::ivec2 to, int pane = 0) {
  check_coordinates(from);
  check_coordinates(to);
  Track track("DDA", {"x", "y"}, pane);
  for (DdaLine line(from, to); line.next();) {
    track(line.at().x, line.at().y);
    track.step({line.position().x, line.position().y});
  }
  return track;
}

inline Track bresenham_track(glm::ivec2 from, glm::ivec2 to, int pane = 0) {
  Track track("Bresenham", {"x", "y", "d"}, pane);
  for (BresenhamSteps line(from, to); line.next();) {
    track(line.at().x, line.at().y);
    track.step({double(line.at().x), double(line.at().y), double(line.decision())});
  }
  return track;
}

}  // namespace kinescope
