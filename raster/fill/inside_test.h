// Whether a point is inside a polygon: a ray from it to the left is crossed by edges. Odd numbers
// of crossings are inside (even-odd rule), or sums of their directions that are not 0 (winding
// number, non-zero rule).
// Source: M. Shimrat, "Algorithm 112: position of point relative to polygon", 1962; K. Weiler in
// "Graphics Gems IV", 1994.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "raster/fill/polygon.h"
#include "raster/path/exact_area.h"

namespace kinescope {

/// Looks at one edge after another. Edges own their upper end and not their lower one, so that a
/// corner counts once where the outline passes the ray, and twice or never where it only touches.
/// A point on an edge belongs to what lies right of it: the rule of ScanlineFill.
class InsideTest {
 public:
  InsideTest(std::span<const glm::dvec2> contour, glm::dvec2 point) : point_(point) {
    contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) { edges_.emplace_back(a, b); });
  }

  bool next() {
    if (++at_ >= static_cast<std::ptrdiff_t>(edges_.size())) return false;
    const auto [a, b] = edge();
    direction_ = 0;
    const bool down = a.y <= point_.y && point_.y < b.y, up = b.y <= point_.y && point_.y < a.y;
    if (!down && !up) return true;
    // Twice the area of the triangle: positive where the point lies right of an edge downwards.
    const double right = (point_.x - a.x) * (b.y - a.y) - (point_.y - a.y) * (b.x - a.x);
    if (down ? right < 0 : right > 0) return true;
    direction_ = down ? 1 : -1;
    winding_ += direction_;
    ++crossings_;
    return true;
  }

  std::pair<glm::dvec2, glm::dvec2> edge() const { return edges_[static_cast<std::size_t>(at_)]; }
  int direction() const { return direction_; }  ///< of this crossing: 1 down, -1 up, 0 none
  int crossings() const { return crossings_; }  ///< so far
  int winding() const { return winding_; }

 private:
  glm::dvec2 point_;
  std::vector<std::pair<glm::dvec2, glm::dvec2>> edges_;
  std::ptrdiff_t at_ = -1;
  int direction_ = 0, crossings_ = 0, winding_ = 0;
};

inline bool is_inside(const Polygon& polygon, glm::dvec2 point, FillRule rule) {
  int crossings = 0, winding = 0;
  for (const Contour& contour : polygon) {
    InsideTest test(contour, point);
    while (test.next()) {
    }
    crossings += test.crossings();
    winding += test.winding();
  }
  return rule == FillRule::kEvenOdd ? crossings % 2 != 0 : winding != 0;
}

}  // namespace kinescope
