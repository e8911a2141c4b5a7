// Brownian motion, and its fractional kind by midpoint displacement.
// Source: Peitgen and Saupe, "The Science of Fractal Images", 1988, ch. 2.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/fractals/random.h"

namespace kinescope {

/// Calls sink(point) for a particle's place after 0, 1, ... steps, each normal of variance 1 in x
/// and in y: after n steps it is sqrt(2 n) away in the mean square.
template <typename Sink>
void brownian_path(std::uint64_t seed, int steps, Sink&& sink) {
  SeededRandom random(seed);
  glm::dvec2 at(0.0);
  sink(at);
  for (int i = 0; i < steps; ++i) {
    at.x += random.normal();
    at.y += random.normal();
    sink(at);
  }
}

/// A line of 2^levels + 1 heights over [0, 1], halved level by level: each midpoint is its
/// neighbours' mean, displaced. Hurst's exponent 1/2 is Brownian motion; the graph's dimension is
/// 2 - hurst. One generation a step.
class MidpointLine {
 public:
  MidpointLine(double hurst, std::uint64_t seed) : heights{0.0, 0.0}, hurst_(hurst), random_(seed) {
    heights[1] = random_.normal();
    deviation_ = std::sqrt(1.0 - std::exp2(2.0 * hurst - 2.0));
  }

  /// Halves every stretch; no further than 2^22.
  bool next() {
    if (heights.size() > std::size_t{1} << 22) return false;
    deviation_ *= std::exp2(-hurst_);
    std::vector<double> finer;
    finer.reserve(2 * heights.size());
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      finer.push_back(heights[i]);
      finer.push_back(0.5 * (heights[i] + heights[i + 1]) + deviation_ * random_.normal());
    }
    finer.push_back(heights.back());
    heights = std::move(finer);
    return true;
  }

  std::vector<double> heights;

 private:
  double hurst_, deviation_ = 1.0;
  SeededRandom random_;
};

}  // namespace kinescope
