// Bezier curves to chords, uniform in the parameter.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace kinescope {

/// Chords for which a curve of the given second difference and factor stays within the tolerance.
/// Not finite gives one chord; the count is bounded, since no screen tells a million chords from
/// the curve.
inline int chord_count(float second_difference, float factor, float tolerance) {
  const float chords = std::ceil(std::sqrt(factor * second_difference / tolerance));
  return chords >= 1 ? static_cast<int>(std::min(chords, 65536.0f)) : 1;
}

/// Calls sink(point) for the end of each chord, the curve's own end last and exact; its start is
/// not repeated. No point of the curve is further than `tolerance` from its chord.
/// Source: the error of a chord, h^2/8 max|B''|.
template <typename Sink>
void flatten_quadratic(glm::vec2 p0, glm::vec2 p1, glm::vec2 p2, float tolerance, Sink&& sink) {
  const int chords = chord_count(glm::length(p0 - 2.0f * p1 + p2), 0.25f, tolerance);
  for (int i = 1; i < chords; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(chords), s = 1 - t;
    sink(s * s * p0 + 2 * s * t * p1 + t * t * p2);
  }
  sink(p2);
}

/// The same for a cubic. Source: Wang's bound (G. Wang, 1984).
template <typename Sink>
void flatten_cubic(glm::vec2 p0, glm::vec2 p1, glm::vec2 p2, glm::vec2 p3, float tolerance,
                   Sink&& sink) {
  const float bend = std::max(glm::length(p0 - 2.0f * p1 + p2), glm::length(p1 - 2.0f * p2 + p3));
  const int chords = chord_count(bend, 0.75f, tolerance);
  for (int i = 1; i < chords; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(chords), s = 1 - t;
    sink(s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3);
  }
  sink(p3);
}

}  // namespace kinescope
