// Any conic within a window, by its explicit equation: column by column where the curve is flatter
// than 45 degrees (by the gradient at the pixel), row by row where it is steeper. Finds every
// branch and needs no start. Source: D. Hearn and M. P. Baker, "Computer Graphics", 1986.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "raster/pixel_rect.h"
#include "raster/scan/conic.h"

namespace kinescope {

/// Pixel by pixel: columns from the left, then rows from the top; no pixel twice. A conic with a
/// coefficient that is not finite has none, nor has a window beyond kLargestCoordinate.
class ConicScan {
 public:
  ConicScan(const Conic& conic, const PixelRect& window);

  bool next();
  glm::ivec2 at() const { return at_; }
  glm::dvec2 point() const { return point_; }  ///< of the curve, before rounding
  bool by_rows() const { return by_rows_; }    ///< in the second part

 private:
  struct Crossings {
    int count = 0;
    std::array<double, 2> along{};  ///< the column's y or the row's x
  };
  Crossings crossings(bool rows, int line) const;

  Conic conic_;
  PixelRect window_;
  bool by_rows_ = false;
  int line_ = 0;
  Crossings found_;
  int taken_ = 0;
  glm::ivec2 at_{0};
  glm::dvec2 point_{0};
};

template <typename Sink>
void conic_scan(const Conic& conic, const PixelRect& window, Sink&& sink) {
  for (ConicScan scan(conic, window); scan.next();) sink(scan.at().x, scan.at().y);
}

}  // namespace kinescope
