// Curves of an initiator and a generator: every line is replaced by a small copy of the generator,
// again and again. Source: Mandelbrot, "The Fractal Geometry of Nature", 1982, ch. 6.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

namespace kinescope {

/// Where a generator's point comes to lie when its line from (0, 0) to (1, 0) becomes another.
inline glm::dvec2 on_line(const glm::dvec2& p, const glm::dvec2& from, const glm::dvec2& to) {
  const glm::dvec2 d = to - from;
  return {from.x + d.x * p.x - d.y * p.y, from.y + d.y * p.x + d.x * p.y};
}

/// Calls sink(from, to) for the lines that are left of one line after so many replacements.
/// @param between the generator's points between (0, 0) and (1, 0): n of them make n + 1 lines
template <typename Sink>
void generator_curve(std::span<const glm::dvec2> between, const glm::dvec2& from,
                     const glm::dvec2& to, int generations, Sink&& sink) {
  if (generations <= 0) return sink(from, to);
  glm::dvec2 last = from;
  for (std::size_t i = 0; i <= between.size(); ++i) {
    const glm::dvec2 next = i < between.size() ? on_line(between[i], from, to) : to;
    generator_curve(between, last, next, generations - 1, sink);
    last = next;
  }
}

/// Lines after so many generations, which grow fast: ask before drawing.
inline double generator_lines(std::size_t between, int generations) {
  return std::pow(static_cast<double>(between) + 1.0, generations);
}

}  // namespace kinescope
