// Mandelbrot and Julia sets by escape time: z -> z^2 + c until |z| > 2.
// Source: Peitgen and Saupe, "The Science of Fractal Images", 1988, ch. 4.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace kinescope {

class Workers;

/// What a picture of a set shows: pixel (i, j), j downwards, stands for
/// centre + step * (i - width / 2, height / 2 - j).
struct EscapeView {
  glm::dvec2 centre{-0.75, 0.0};
  double step = 3.0 / 1080;
  int width = 1920, height = 1080;
  int most = 1000;  ///< iterations after which a point counts as inside
  /// The c of a Julia set, whose z begins at the pixel; without it the Mandelbrot set, whose c is.
  std::optional<glm::dvec2> julia;

  glm::dvec2 at(int i, int j) const {
    return {centre.x + step * (i - width / 2), centre.y + step * (height / 2 - j)};
  }
};

/// Iterations after which |z| > 2, at most `most`: the readable reference.
inline int escape_time(glm::dvec2 z, const glm::dvec2& c, int most) {
  int n = 0;
  for (; n < most; ++n) {
    const double xx = z.x * z.x, yy = z.y * z.y;
    if (!(xx + yy <= 4.0)) break;
    z = {(xx - yy) + c.x, 2.0 * (z.x * z.y) + c.y};
  }
  return n;
}
inline int escape_time(const EscapeView& view, int i, int j) {
  const glm::dvec2 p = view.at(i, j);
  return view.julia ? escape_time(p, *view.julia, view.most)
                    : escape_time(glm::dvec2(0.0), p, view.most);
}

/// One orbit, a point at a time, as a demo draws it: sink(z) for z0 and on, until it escapes.
template <typename Sink>
void escape_orbit(glm::dvec2 z, const glm::dvec2& c, int most, Sink&& sink) {
  for (int n = 0; n < most && z.x * z.x + z.y * z.y <= 4.0; ++n) {
    sink(z);
    z = {(z.x * z.x - z.y * z.y) + c.x, 2.0 * (z.x * z.y) + c.y};
  }
}

/// Escape times of a row, SIMD: to the bit as the reference says. `times` has room for the width.
void escape_row(const EscapeView& view, int j, std::int32_t* times);

/// All rows, on all workers. @throws Error (bad input) for sizes that are not positive or above
///                                  2^26 pixels
std::vector<std::int32_t> escape_times(const EscapeView& view, Workers& workers);

}  // namespace kinescope
