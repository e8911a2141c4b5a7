// An ellipse in integers by midpoints, in two regions: where it is flatter than 45 degrees a step
// is a column, where it is steeper a row.
// Source: J. R. Van Aken, "An efficient ellipse-drawing algorithm", 1984.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/scan/circle_symmetry.h"
#include "raster/scan/limits.h"

namespace kinescope {

/// The quadrant from (0, b) to (a, 0). A negative radius has no pixel. At tips that turn by 45
/// degrees within a pixel (b^2/a or a^2/b below 1) a pixel may lie one off, as in every algorithm
/// of this kind; no gap comes of it.
class MidpointEllipse {
 public:
  explicit MidpointEllipse(glm::ivec2 radii)
      : a_(radii.x), b_(radii.y), x_(-1), y_(b_), decision_(4 * b_ * b_ - a_ * a_ * (4 * b_ - 1)) {}

  bool next();
  glm::ivec2 at() const { return {x_, y_}; }  ///< from the centre
  bool steep() const { return steep_; }       ///< in the second region
  /// 4 (b^2 x^2 + a^2 y^2 - a^2 b^2) at the midpoint of the next two pixels, (x + 1, y - 1/2) or in
  /// the second region (x + 1/2, y - 1): negative inside.
  std::int64_t decision() const { return decision_; }

 private:
  std::int64_t a_, b_, x_, y_, decision_;
  bool steep_ = false;
};

/// @throws Error (bad input) beyond the limits
template <typename Sink>
void midpoint_ellipse(glm::ivec2 centre, glm::ivec2 radii, Sink&& sink) {
  check_round(centre, std::max(radii.x, radii.y));
  for (MidpointEllipse e(radii); e.next();) four_way(centre, e.at(), sink);
}

}  // namespace kinescope
