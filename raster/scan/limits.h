// How far scan conversion reaches: within these its integers cannot overflow, and nothing runs for
// minutes.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

namespace kinescope {

constexpr int kLargestCoordinate = 1 << 29;
/// Of circles and ellipses that are drawn whole.
constexpr int kLargestRadius = 1 << 18;

/// @throws Error (bad input) if a coordinate lies beyond kLargestCoordinate
void check_coordinates(glm::ivec2 p);

/// @throws Error (bad input) if the centre lies beyond kLargestCoordinate or the radius beyond
/// `largest`
void check_round(glm::ivec2 centre, int radius, int largest = kLargestRadius);

inline bool is_drawable(glm::dvec2 p) {  // not so for NaN
  return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate;
}

}  // namespace kinescope
