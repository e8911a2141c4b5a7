// Koch's curve whose bumps go to either side by lot: as rough, but never the same.
// Source: Mandelbrot, "The Fractal Geometry of Nature", 1982, ch. 6.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/fractals/generator_curve.h"
#include "engine/fractals/random.h"

namespace kinescope {

/// Adds the points from the last one to `to`, 4^n of them; at most 10 generations.
inline void add_random_koch(std::vector<glm::dvec2>& points, const glm::dvec2& to, int generations,
                            SeededRandom& random) {
  if (generations <= 0) return points.push_back(to);
  const int rest = std::min(generations, 10) - 1;
  const glm::dvec2 from = points.back();
  const double height = std::sqrt(3.0) / (random.uniform() < 0.5 ? 6 : -6);
  for (const glm::dvec2& p : {glm::dvec2(1 / 3.0, 0), {0.5, height}, {2 / 3.0, 0}, {1, 0}}) {
    add_random_koch(points, on_line(p, from, to), rest, random);
  }
}

/// From (0, 0) to (1, 0).
inline std::vector<glm::dvec2> random_koch_curve(int generations, SeededRandom& random) {
  std::vector<glm::dvec2> points{{0, 0}};
  add_random_koch(points, {1, 0}, generations, random);
  return points;
}

}  // namespace kinescope
