// The courses of circle algorithms: an octant's pixels, and their mirrors in seven more colours.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "demos/lesson/track.h"
#include "raster/base/error.h"
#include "raster/scan/bresenham_circle.h"
#include "raster/scan/dda_ellipse.h"
#include "raster/scan/explicit_circle.h"
#include "raster/scan/midpoint_circle.h"
#include "raster/scan/parametric_circle.h"

namespace kinescope {

/// @throws Error (bad input) for what no circle has
inline void check_radius(glm::ivec2 centre, int radius) {
  check_round(centre, radius);
  if (radius < 0) throw_bad_input("radius: a circle's is not negative");
}

/// Each step: the octant's pixel and its mirrors. `state` gives what the algorithm knows of it.
template <typename Octant, typename State>
Track octant_track(std::string name, std::string column, Octant octant, glm::ivec2 centre, int pane,
                   State&& state) {
  constexpr Srgb8 kPlum{190, 96, 200, 255};
  constexpr std::array kInks = {theme::kText, theme::kAccent, theme::kCool, theme::kGreen,
                                theme::kBlue, theme::kRed,    theme::kDim,  kPlum};
  Track track(std::move(name), {"x", "y", std::move(column)}, pane);
  while (octant.next()) {
    std::size_t mirror = 0;
    eight_way(centre, octant.at(),
              [&](int x, int y) { track.plot(x, y, kInks[mirror++ % kInks.size()]); });
    track.step({double(octant.at().x), double(octant.at().y), double(state(octant))});
  }
  return track;
}

enum class CircleMethod { kExplicit, kParametric, kDda, kBresenham, kMidpoint };

inline Track circle_track(CircleMethod method, glm::ivec2 centre, int radius, int pane) {
  check_radius(centre, radius);
  switch (method) {
    case CircleMethod::kExplicit:
      return octant_track("explicit", "root", ExplicitCircle(radius), centre, pane,
                          [](const ExplicitCircle& c) { return c.height(); });
    case CircleMethod::kParametric:
      return octant_track("parametric", "angle", ParametricCircle(radius), centre, pane,
                          [](const ParametricCircle& c) { return c.angle(); });
    case CircleMethod::kBresenham:
      return octant_track("Bresenham", "d", BresenhamCircle(radius), centre, pane,
                          [](const BresenhamCircle& c) { return c.decision(); });
    case CircleMethod::kMidpoint:
      return octant_track("midpoint", "d", MidpointCircle(radius), centre, pane,
                          [](const MidpointCircle& c) { return c.decision(); });
    case CircleMethod::kDda:
      break;
  }
  Track track("DDA", {"x", "y", "step"}, pane);
  for (DdaEllipse circle({radius, radius}); circle.next();) {
    track(centre.x + circle.at().x, centre.y + circle.at().y);
    track.step({circle.position().x, circle.position().y, circle.step()});
  }
  return track;
}

}  // namespace kinescope
