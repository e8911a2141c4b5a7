// A circle's eight octants and an ellipse's four quadrants from one.
#pragma once

#include <glm/vec2.hpp>

namespace kinescope {

/// Calls sink(x, y) once for each different pixel of (+-p.x, +-p.y) about the centre.
template <typename Sink>
void four_way(glm::ivec2 centre, glm::ivec2 p, Sink&& sink) {
  sink(centre.x + p.x, centre.y + p.y);
  if (p.x != 0) sink(centre.x - p.x, centre.y + p.y);
  if (p.y != 0) sink(centre.x + p.x, centre.y - p.y);
  if (p.x != 0 && p.y != 0) sink(centre.x - p.x, centre.y - p.y);
}

/// The same, and with x and y exchanged.
template <typename Sink>
void eight_way(glm::ivec2 centre, glm::ivec2 p, Sink&& sink) {
  four_way(centre, p, sink);
  if (p.x != p.y) four_way(centre, {p.y, p.x}, sink);
}

/// Runs a stepper of one octant to its end.
template <typename Octant, typename Sink>
void all_octants(Octant octant, glm::ivec2 centre, Sink&& sink) {
  while (octant.next()) eight_way(centre, octant.at(), sink);
}

}  // namespace kinescope
