// A lesson's world: coarse pixels, in one pane or in several, on a screen of 640x480.
#pragma once

#include <glm/vec2.hpp>

#include "raster/pixel_rect.h"

namespace kinescope {

struct World {
  static constexpr int kScreenWidth = 640, kScreenHeight = 480;

  int cell = 16;           ///< screen pixels a side of a coarse one
  glm::ivec2 panes{1, 1};  ///< across and down
  bool centred = false;    ///< users count from the middle, y upwards

  int columns() const { return kScreenWidth / panes.x / cell; }  ///< of a pane
  int rows() const { return kScreenHeight / panes.y / cell; }
  PixelRect window() const { return {0, 0, columns(), rows()}; }
  /// A pane's corner, screen pixels.
  glm::ivec2 corner(int pane) const {
    return {pane % panes.x * (kScreenWidth / panes.x), pane / panes.x * (kScreenHeight / panes.y)};
  }
  /// Pixels as users name them, and back.
  glm::dvec2 named(glm::dvec2 p) const {
    return centred ? glm::dvec2(p.x - columns() / 2, rows() / 2 - p.y) : p;
  }
  glm::dvec2 of_name(glm::dvec2 p) const {
    return centred ? glm::dvec2(p.x + columns() / 2, rows() / 2 - p.y) : p;
  }
  /// Where a point so named is drawn: in the middle of its pixel.
  glm::dvec2 middle_of(glm::dvec2 name) const { return of_name(name) + 0.5; }
};

}  // namespace kinescope
