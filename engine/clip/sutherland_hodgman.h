// Polygons clipped to a window or a convex polygon, one side a stage.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "engine/clip/clip_window.h"
#include "engine/clip_homogeneous.h"

namespace kinescope {

/// What a clipper does with an edge. Corners on its side are inside.
enum class EdgeCase {
  kInside,   ///< hands on the second corner
  kLeaving,  ///< hands on the crossing
  kOutside,  ///< hands on nothing
  kEntering  ///< hands on the crossing and the second corner
};
struct ClippedEdge {
  glm::dvec2 from{0.0}, to{0.0};
  EdgeCase what = EdgeCase::kInside;
  int handed_on = 0;  ///< corners; a crossing that is a corner itself counts once
};

/// Four clippers in a row (or as many as a convex polygon has sides). Concave polygons may come out
/// with edges that run along a side and back: weiler_atherton.h tells their parts apart.
class SutherlandHodgman {
 public:
  /// Sides left, right, bottom, top. Corners that are not finite leave nothing.
  SutherlandHodgman(const ClipWindow& window, std::span<const glm::dvec2> polygon);
  /// @param convex its corners, in either direction. @throws Error (bad input) if they turn both
  /// ways
  SutherlandHodgman(std::span<const glm::dvec2> convex, std::span<const glm::dvec2> polygon);

  /// Runs the next clipper; false when there is none left.
  bool next();

  int stage() const { return stage_; }  ///< clippers that have run
  int stages() const { return static_cast<int>(planes_.size()); }
  /// The side that clipper k keeps the left of; for a window, from corner to corner.
  Segment2 side(int k) const { return sides_[static_cast<std::size_t>(k)]; }
  /// What the clippers so far have left.
  const std::vector<glm::dvec2>& polygon() const { return polygon_; }
  /// The edges that went into clipper k, as it would treat them, the last corner's first.
  std::vector<ClippedEdge> edges(int k, std::span<const glm::dvec2> polygon) const;

 private:
  void start(std::span<const glm::dvec2> polygon);

  std::vector<ClipPlane> planes_;
  std::vector<Segment2> sides_;
  std::vector<glm::dvec2> polygon_;
  std::vector<ClipVertex> from_, to_;
  int stage_ = 0;
};

/// All stages. Empty if nothing is left, or if fewer than three corners went in.
std::vector<glm::dvec2> clip_polygon(const ClipWindow& window, std::span<const glm::dvec2> polygon);
std::vector<glm::dvec2> clip_polygon(std::span<const glm::dvec2> convex,
                                     std::span<const glm::dvec2> polygon);

}  // namespace kinescope
