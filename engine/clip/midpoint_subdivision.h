// Lines clipped by halving: no division, as hardware once did it.
// Source: Sproull and Sutherland, "A Clipping Divider", 1968.
#pragma once

#include <optional>

#include "engine/clip/cohen_sutherland.h"

namespace kinescope {

/// Looks for the visible point nearest to the line's one end, then to its other.
class MidpointSubdivision {
 public:
  /// Rejects at once what is not finite.
  /// @param tolerance stops halving at this length, such as a pixel; 0 goes on to the last bit
  MidpointSubdivision(const ClipWindow& window, const Segment2& line, double tolerance = 0.0);

  /// Halves once, or decides on an end; false once both are decided.
  bool next();

  int end = 0;                 ///< 0 while the first end is sought, then 1
  glm::dvec2 outer, inner;     ///< what is still halved: the outer end is not visible
  glm::dvec2 middle{0.0};      ///< of the last step
  bool rejected_half = false;  ///< whether that step threw the outer half away
  int halvings = 0;
  ClipState state;
  Segment2 segment;  ///< the answer, when accepted

 private:
  bool found(const glm::dvec2& p);

  ClipWindow window_;
  Segment2 line_;
  double tolerance_;
};

std::optional<Segment2> clip_midpoint_subdivision(const ClipWindow& window, const Segment2& line,
                                                  double tolerance = 0.0);

}  // namespace kinescope
