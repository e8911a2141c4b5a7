// The exact area that lies right of an edge in a pixel.
#pragma once

#include <algorithm>
#include <cmath>

namespace kinescope {

/// Over a row (or the part of its height that an edge crosses) an edge moves sideways by `run`
/// pixels. The share of a pixel right of it, as the pixel moves past the edge, is the integral of
/// a trapezoid, a box one pixel wide smeared by a box `run` wide: a square, a straight part, a
/// square. All terms stay small and well-conditioned for any run.
struct Ramp {
  float flat;      ///< half the straight part, pixels
  float rate;      ///< gain a pixel in it
  float bend;      ///< gain of each curved part
  float inv_bend;  ///< one over its length
  float start;     ///< distance of the ends from the middle, in lengths of a curved part

  explicit Ramp(float run) {
    const float longer = std::max(run, 1.0f), shorter = std::max(std::min(run, 1.0f), 1e-6f);
    flat = 0.5f * (longer - shorter);
    rate = 1 / longer;
    bend = 0.5f * shorter * rate;
    inv_bend = 1 / shorter;
    start = 0.5f * (longer + shorter) * inv_bend;
  }

  /// @param distance from the edge's middle to the pixel's, pixels, positive if it lies right
  /// @return the share right of the edge less one half
  float at(float distance) const {
    const float t = std::abs(distance);
    const float rest = std::min(std::max(start - t * inv_bend, 0.0f), 1.0f);
    return std::copysign(std::min(t, flat) * rate + (bend - bend * (rest * rest)), distance);
  }
};

}  // namespace kinescope
