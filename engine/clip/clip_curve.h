// Curves clipped to a window: which stretches of their parameter are inside.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "engine/clip/clip_window.h"

namespace kinescope {

/// A stretch of a curve's parameter.
struct CurvePart {
  double from, to;
};

/// An ellipse with axes along x and y: centre + (radii.x cos a, radii.y sin a).
struct ClippedEllipse {
  glm::dvec2 centre{0.0};
  glm::dvec2 radii{1.0};
};
/// The arcs inside, in radians from 0, each with from < to and from in [0, 2 pi); the whole ellipse
/// is one part of 2 pi. Nothing for radii that are not positive and finite.
/// The angles are solved for: where x or y equals a side's.
std::vector<CurvePart> clip_ellipse(const ClipWindow& window, const ClippedEllipse& ellipse);

/// The parts of a Bezier curve inside, within [0, 1], ends to about 2^-44. A curve whose control
/// points are all inside is kept, all beyond one side dropped, any other halved.
/// Nothing for control points that are not finite.
std::vector<CurvePart> clip_bezier(const ClipWindow& window, std::span<const glm::dvec2> control);

}  // namespace kinescope
