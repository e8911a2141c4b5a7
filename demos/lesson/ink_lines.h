// Lines and figures of real coordinates as a lesson's pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "demos/lesson/track.h"
#include "demos/lesson/world.h"
#include "engine/clip/liang_barsky.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {

/// Plots on the paper itself, for what is drawn anew each step.
struct PaperInk {
  Image<Srgb8>& paper;
  void plot(int x, int y, Srgb8 colour) const {
    if (paper.contains(x, y)) paper.at(x, y) = colour;
  }
};

/// Plots the segment's pixels within a pane; nothing of one that is not finite.
/// @param ink a Track or PaperInk
template <typename Ink>
void ink_line(Ink& ink, const World& world, const glm::dvec2& from, const glm::dvec2& to,
              Srgb8 colour = theme::kText) {
  const ClipWindow pane{{0, 0}, {world.columns() - 0.001, world.rows() - 0.001}};
  const auto part = clip_liang_barsky(pane, {from, to});
  if (!part) return;
  BresenhamSteps line(glm::ivec2(part->from), glm::ivec2(part->to));
  while (line.next()) ink.plot(line.at().x, line.at().y, colour);
}

/// Plots a point's pixel, if it lies in the pane.
template <typename Ink>
void ink_point(Ink& ink, const World& world, const glm::dvec2& p, Srgb8 colour = theme::kText) {
  ink_line(ink, world, p, p, colour);
}

/// The rectangle that holds a figure, and where its points lie in a pane: as large as fits, y up.
class FittedFigure {
 public:
  void hold(const glm::dvec2& p) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  glm::dvec2 place(const World& world, const glm::dvec2& p) const {
    const glm::dvec2 size(world.columns(), world.rows());
    const glm::dvec2 room = 0.9 * size, extent = glm::max(high_ - low_, glm::dvec2(1e-9));
    const double scale = std::min(room.x / extent.x, room.y / extent.y);
    const glm::dvec2 off = scale * (p - 0.5 * (low_ + high_));
    return 0.5 * size + glm::dvec2(off.x, -off.y);
  }

 private:
  glm::dvec2 low_{1e300}, high_{-1e300};
};

}  // namespace kinescope
