// Lines and figures of real coordinates as a lesson's pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

/// Plots those of a segment's pixels that a part of it passes: a part's own might be others.
template <typename Ink>
void ink_part(Ink& ink, const World& world, const Segment2& whole, const Segment2& part,
              Srgb8 colour) {
  const glm::dvec2 way = whole.to - whole.from;
  const auto along = [&](const glm::dvec2& p) { return glm::dot(p - whole.from, way); };
  const auto [low, high] = std::minmax({along(part.from), along(part.to)});
  struct Between {
    Ink& ink;
    glm::dvec2 from, way;
    double low, high;
    void plot(int x, int y, Srgb8 c) const {
      const double at = glm::dot(glm::dvec2(x, y) + 0.5 - from, way);
      if (at >= low && at <= high) ink.plot(x, y, c);
    }
  };
  const Between between{ink, whole.from, way, low, high};
  ink_line(between, world, whole.from, whole.to, colour);
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
