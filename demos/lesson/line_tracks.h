// The courses of line algorithms, for the demos that compare them.
#pragma once

#include "demos/lesson/track.h"
#include "demos/lesson/world.h"
#include "raster/scan/bresenham_steps.h"
#include "raster/scan/dda_line.h"

namespace kinescope {

/// The state names pixels as the world does. @throws Error (bad input) beyond what can be drawn
inline Track dda_track(glm::ivec2 from, glm::ivec2 to, const World& world, int pane = 0,
                       Srgb8 ink = theme::kText) {
  check_coordinates(from);
  check_coordinates(to);
  Track track("DDA", {"x", "y"}, pane, ink);
  for (DdaLine line(from, to); line.next();) {
    track(line.at().x, line.at().y);
    const glm::dvec2 at = world.named(line.position());
    track.step({at.x, at.y});
  }
  return track;
}

inline Track bresenham_track(glm::ivec2 from, glm::ivec2 to, const World& world, int pane = 0,
                             Srgb8 ink = theme::kText) {
  Track track("Bresenham", {"x", "y", "d"}, pane, ink);
  for (BresenhamSteps line(from, to); line.next();) {
    track(line.at().x, line.at().y);
    const glm::dvec2 at = world.named(line.at());
    track.step({at.x, at.y, double(line.decision())});
  }
  return track;
}

}  // namespace kinescope
