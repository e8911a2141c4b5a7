#include "raster/scan/conic_tracer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kinescope {

glm::dvec2 ConicTracer::tangent(glm::dvec2 p) const {
  const glm::dvec2 g = conic_.gradient(p.x, p.y);
  return backwards_ ? glm::dvec2(-g.y, g.x) : glm::dvec2(g.y, -g.x);
}

bool ConicTracer::next() {
  ++steps_;
  if (steps_ == 0) return inside();
  // A degenerate conic could be walked in circles that miss the start.
  const std::int64_t most = 4 * (std::int64_t{window_.x1} - window_.x0 + window_.y1 - window_.y0);
  if (closed_ || steps_ > most) return false;
  const glm::dvec2 here = tangent(at_);
  const double most_along = std::max(std::abs(here.x), std::abs(here.y));
  if (!(most_along > 0) || !std::isfinite(most_along)) return false;
  // The octant half a pixel ahead: at its border the one that begins.
  const glm::dvec2 along = tangent(glm::dvec2(at_) + here / (2 * most_along));
  const glm::dvec2 g = backwards_ ? glm::dvec2(along.y, -along.x) : glm::dvec2(-along.y, along.x);
  const bool steep = std::abs(along.y) > std::abs(along.x);
  const auto sign = [](double v) { return v < 0 ? -1 : 1; };
  axial_ = steep ? glm::ivec2(0, sign(along.y)) : glm::ivec2(sign(along.x), 0);
  const double across = steep ? g.x : g.y;  // how the conic grows across the axis
  aside_ = {0, 0};
  const glm::ivec2 ahead = at_ + axial_;
  for (const int side : {sign(steep ? along.x : along.y), -sign(steep ? along.x : along.y)}) {
    const glm::dvec2 midpoint = steep ? glm::dvec2(ahead.x + side / 2.0, ahead.y)
                                      : glm::dvec2(ahead.x, ahead.y + side / 2.0);
    decision_ = conic_(midpoint.x, midpoint.y);
    // The curve lies beyond the midpoint if the conic still has to grow (or fall) towards zero.
    if (decision_ * across * side >= 0) continue;
    aside_ = steep ? glm::ivec2(side, 0) : glm::ivec2(0, side);
    break;
  }
  at_ = ahead + aside_;
  // A start beside the walk's own pixels is not met again, but what follows it is.
  if (steps_ == 1) second_ = at_;
  closed_ = at_ == start_ || (steps_ > 1 && at_ == second_);
  return !closed_ && inside();
}

}  // namespace kinescope
