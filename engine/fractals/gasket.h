// Cantor's set and Sierpinski's triangle, carpet and tetrahedron, generation by generation.
// Source: Mandelbrot, "The Fractal Geometry of Nature", 1982, ch. 8, 13 and 14.
#pragma once

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kinescope {

/// Deeper generations are drawn as this one: smaller than any pixel, and too many.
inline constexpr int kDeepestGasket = 12;
inline constexpr int kDeepestCantor = 20;

/// Calls sink(from, to) for the 2^n stretches that are left of [from, to] when the middle third has
/// been taken away n times.
template <typename Sink>
void cantor_set(double from, double to, int generations, Sink&& sink) {
  if (generations <= 0) return sink(from, to);
  const int rest = std::min(generations, kDeepestCantor) - 1;
  const double third = (to - from) / 3.0;
  cantor_set(from, from + third, rest, sink);
  cantor_set(to - third, to, rest, sink);
}

using Triangle2 = std::array<glm::dvec2, 3>;
/// Calls sink(Triangle2) for the 3^n triangles left when the middle one has been taken away n
/// times.
template <typename Sink>
void sierpinski_triangle(const Triangle2& whole, int generations, Sink&& sink) {
  if (generations <= 0) return sink(whole);
  const int rest = std::min(generations, kDeepestGasket) - 1;
  for (const glm::dvec2& corner : whole) {
    sierpinski_triangle(
        Triangle2{(corner + whole[0]) * 0.5, (corner + whole[1]) * 0.5, (corner + whole[2]) * 0.5},
        rest, sink);
  }
}

/// Calls sink(low, high) for the 8^n squares left of one when the middle ninth has been taken away
/// n times, at most 8 times.
template <typename Sink>
void sierpinski_carpet(const glm::dvec2& low, const glm::dvec2& high, int generations,
                       Sink&& sink) {
  if (generations <= 0) return sink(low, high);
  const int rest = std::min(generations, 8) - 1;
  const glm::dvec2 third = (high - low) / 3.0;
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;
    const glm::dvec2 corner = low + third * glm::dvec2(i % 3, i / 3);
    sierpinski_carpet(corner, corner + third, rest, sink);
  }
}

using Tetrahedron = std::array<glm::dvec3, 4>;
/// Calls sink(Tetrahedron) for the 4^n tetrahedra at the corners of one, at most 10 times.
template <typename Sink>
void sierpinski_tetrahedron(const Tetrahedron& whole, int generations, Sink&& sink) {
  if (generations <= 0) return sink(whole);
  const int rest = std::min(generations, 10) - 1;
  for (const glm::dvec3& corner : whole) {
    Tetrahedron part;
    for (std::size_t i = 0; i < 4; ++i) part[i] = (corner + whole[i]) * 0.5;
    sierpinski_tetrahedron(part, rest, sink);
  }
}

}  // namespace kinescope
