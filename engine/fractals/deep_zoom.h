// The Mandelbrot set far below the spacing of doubles, by perturbation: one orbit is followed in
// arbitrary precision, every pixel's difference from it in doubles.
// Source: Martin, "Superfractalthing Maths", 2013; rebasing after Zhuoran, 2021.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace kinescope {

class Workers;

/// As EscapeView, its centre in decimal digits, as many as it takes.
struct DeepView {
  std::string centre_x = "-0.75", centre_y = "0";
  double step = 1e-100;  ///< down to 1e-280
  int width = 320, height = 240;
  int most = 1000;

  glm::dvec2 offset(int i, int j) const {
    return {step * (i - width / 2), step * (height / 2 - j)};
  }
};

/// Bits of mantissa that tell the view's pixels apart, with some to spare.
int deep_precision_bits(const DeepView& view);

/// z_0 = 0, z_1 = c, ... of the view's centre, rounded to doubles, until |z| > 2 or `most`
/// iterations. @throws Error (bad input) unless the centre is two decimal numbers
std::vector<glm::dvec2> reference_orbit(const DeepView& view);

/// Escape time of the point at an offset from the orbit's. Where the point comes nearer to 0 than
/// to the orbit, it goes on from the orbit's start: so no pixel is a glitch. Only where an orbit
/// rests on |z| = 2 itself, as at -2, does a difference below a double's spacing escape some steps
/// late.
int perturbed_escape_time(const std::vector<glm::dvec2>& orbit, const glm::dvec2& offset, int most);

/// All pixels, on all workers. @throws Error (bad input) as reference_orbit, or for sizes that
///                                        are not positive, or a step out of range
std::vector<std::int32_t> deep_escape_times(const DeepView& view, Workers& workers);

/// The readable reference: the same in arbitrary precision all the way.
int exact_escape_time(const DeepView& view, const glm::dvec2& offset);

/// The view with its centre moved by an offset, exactly enough for its step.
DeepView moved(const DeepView& view, const glm::dvec2& offset);

}  // namespace kinescope
