// Curves clipped to a window: which stretches of their parameter are inside.
#pragma once

#include <algorithm>
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

/// Calls sink(part) for those pieces of a stretch that one of the parts holds, in order, so that a
/// curve drawn in chords changes where it enters and leaves.
/// @param period of a closed curve, whose parts may end beyond it
template <typename Sink>
void for_each_kept(std::span<const CurvePart> parts, const CurvePart& stretch, double period,
                   Sink&& sink) {
  const auto kept = [&](double t) {
    return std::any_of(parts.begin(), parts.end(), [&](const CurvePart& part) {
      return (t >= part.from && t <= part.to) || (t + period >= part.from && t + period <= part.to);
    });
  };
  std::vector<double> cuts = {stretch.from, stretch.to};
  for (const CurvePart& part : parts) {
    for (const double end : {part.from, part.to}) {
      const double t = end > period ? end - period : end;
      if (t > stretch.from && t < stretch.to) cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (kept(0.5 * (cuts[i] + cuts[i + 1]))) sink(CurvePart{cuts[i], cuts[i + 1]});
  }
}

}  // namespace kinescope
