// Points to draw curves by.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace kinescope {

inline std::vector<glm::dvec2> random_points(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> u(-10, 10);
  std::vector<glm::dvec2> points(count);
  for (glm::dvec2& p : points) p = {u(random), u(random)};
  return points;
}

}  // namespace kinescope
