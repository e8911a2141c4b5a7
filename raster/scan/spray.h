// A spray can: points at random, as many on each patch of its disc as on any other.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

namespace kinescope {

/// Calls sink(x, y) for `count` points within the radius. The same point may come again.
/// @param random whose uniform() lies in [0, 1)
template <typename Random, typename Sink>
void spray(glm::dvec2 centre, double radius, int count, Random& random, Sink&& sink) {
  for (int i = 0; i < count; ++i) {
    // A ring's area grows with its radius: so the root.
    const double r = radius * std::sqrt(random.uniform());
    const double turn = 2 * std::numbers::pi * random.uniform();
    sink(static_cast<int>(std::floor(centre.x + r * std::cos(turn))),
         static_cast<int>(std::floor(centre.y + r * std::sin(turn))));
  }
}

}  // namespace kinescope
