// Two curves that follow one another, and their hodographs: a derivative's vectors, drawn from one
// origin. Source: Farin, "Curves and Surfaces for CAGD", 1993, 4.3.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "demos/lesson/lesson.h"

namespace kinescope {

/// Bezier curves by their control points.
using TwoPieces = std::array<std::vector<glm::dvec2>, 2>;

struct PiecesPlan {
  World world;
  int steps = 60;  ///< a piece
};
/// Control points are pixels of the pane.
Track pieces_track(const PiecesPlan& plan, const char* name, int pane, const TwoPieces& pieces);

/// Fitted into the pane with its origin; adds axes and the two vectors of the joint: of G1 they
/// point the same way, of C1 they are one. y grows downwards, as in the curve's pane.
Track hodograph(const PiecesPlan& plan, const char* name, int pane, const TwoPieces& derivatives,
                Course& course);

}  // namespace kinescope
