// Arcs of circles and ellipses: the pixels of the whole whose direction lies in a sector.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/scan/midpoint_circle.h"
#include "raster/scan/midpoint_ellipse.h"

namespace kinescope {

/// Directions from one angle on, by a sweep of either sign; radians, from x towards y. A full turn
/// or more holds every direction; what is not finite none.
class Sector {
 public:
  Sector(double start, double sweep);
  bool contains(glm::dvec2 direction) const;

 private:
  glm::dvec2 from_{1, 0}, to_{1, 0};
  bool empty_ = false, whole_ = false, narrow_ = false, over_half_ = false;
};

/// The pixels of a midpoint circle, once around from (r, 0) towards y, octant after octant.
class CircleWalk {
 public:
  explicit CircleWalk(int radius);

  bool next();
  glm::ivec2 at() const { return at_; }   ///< from the centre
  int octant() const { return octant_; }  ///< 0 from the x axis to the diagonal, and so on

 private:
  glm::ivec2 placed(std::int64_t i) const;

  MidpointCircle circle_;
  std::int64_t columns_ = 0;  ///< of one octant
  bool diagonal_ = false;     ///< its last column lies on the diagonal
  std::int64_t i_ = -1;       ///< place in the octant, in the walk's direction
  int octant_ = 0;
  glm::ivec2 at_{0};
};

/// Calls sink(x, y) for each pixel of the arc whose centre lies within the sector, in order from
/// the sector's end that comes first in the turn from x towards y.
/// @throws Error (bad input) beyond the limits
template <typename Sink>
void arc(glm::ivec2 centre, int radius, double start, double sweep, Sink&& sink) {
  check_round(centre, radius);
  const Sector sector(start, sweep);
  // What lies between the x axis and the first pixel outside comes last.
  bool seen_outside = false;
  std::int64_t early = 0;
  for (CircleWalk walk(radius); walk.next();) {
    const bool inside = sector.contains(walk.at());
    seen_outside |= !inside;
    early += !seen_outside;
    if (inside && seen_outside) sink(centre.x + walk.at().x, centre.y + walk.at().y);
  }
  for (CircleWalk walk(radius); early > 0 && walk.next(); --early) {
    sink(centre.x + walk.at().x, centre.y + walk.at().y);
  }
}

/// The arc's pixels within a window, in no order, at the cost of what is seen.
template <typename Sink>
void arc_clipped(glm::ivec2 centre, int radius, double start, double sweep, const PixelRect& window,
                 Sink&& sink) {
  const Sector sector(start, sweep);
  midpoint_circle_clipped(centre, radius, window, [&](int x, int y) {
    if (sector.contains({x - centre.x, y - centre.y})) sink(x, y);
  });
}

/// The pixels of a midpoint ellipse within the sector, quadrant by quadrant.
template <typename Sink>
void ellipse_arc(glm::ivec2 centre, glm::ivec2 radii, double start, double sweep, Sink&& sink) {
  const Sector sector(start, sweep);
  midpoint_ellipse(centre, radii, [&](int x, int y) {
    if (sector.contains({x - centre.x, y - centre.y})) sink(x, y);
  });
}

}  // namespace kinescope
