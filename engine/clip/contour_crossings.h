// Where the contours of two regions cross, for Weiler and Atherton's clipper.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/clip/region.h"

namespace kinescope {

/// A place on a contour: from corner `edge`, the part `t` of the way to the next.
struct ContourPlace {
  std::size_t contour = 0, edge = 0;
  double t = 0.0;
};

struct ContourCrossing {
  glm::dvec2 point{0.0};
  bool entering = false;  ///< the subject passes to the left of the clip contour
  ContourPlace on_subject, on_clip;
};

/// All crossings, and their order along each contour: the subject enters and leaves by turns.
/// Coincident corners and edges need no special case: the subject is thought to be moved by (e,
/// e^2) with e smaller than any number, after Edelsbrunner and Muecke, "Simulation of Simplicity",
/// 1990.
struct CrossingLists {
  std::vector<ContourCrossing> crossings;
  std::vector<std::vector<std::size_t>> along_subject, along_clip;  ///< a list for each contour
};

/// Both regions oriented, or the clip turned round if what lies outside it is to be kept.
/// @throws Error (bad input) where a region's contours cross one another
CrossingLists contour_crossings(const Region& subject, const Region& clip, bool keep_inside);

/// The same thought movement, for contours without a crossing.
bool subject_point_in_clip(const glm::dvec2& subject_point, const Region& clip);
bool clip_point_in_subject(const glm::dvec2& clip_point, const Region& subject);

}  // namespace kinescope
