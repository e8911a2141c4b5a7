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

/// A point of the orbit that is followed in arbitrary precision, rounded.
struct OrbitPoint {
  glm::dvec2 z;
  double excess;  ///< |z|^2 - 4 of the point before it was rounded
};

/// z_0 = 0, z_1 = c, ... of the view's centre, until |z| > 4 or `most` iterations: a pixel that
/// stays where the centre leaves then lies so far from it that it may go on alone.
/// @throws Error (bad input) unless the centre is two decimal numbers
std::vector<OrbitPoint> reference_orbit(const DeepView& view);

/// Escape time of the point at an offset from the orbit's. Where the point comes nearer to 0 than
/// to the orbit, it goes on from the orbit's start: so no pixel is a glitch. Near |z| = 2 the
/// difference itself decides, however far below a double's spacing: the orbit of -2 rests there.
/// What differs from another pixel by less than a double's rounding of its offset is not told
/// apart.
int perturbed_escape_time(const std::vector<OrbitPoint>& orbit, const glm::dvec2& offset, int most);

/// All pixels, on all workers. @throws Error (bad input) as reference_orbit, or for sizes that
///                                        are not positive, or a step out of range
std::vector<std::int32_t> deep_escape_times(const DeepView& view, Workers& workers);

/// The readable reference: the same in arbitrary precision all the way.
int exact_escape_time(const DeepView& view, const glm::dvec2& offset);

/// The view with its centre moved by an offset, exactly enough for its step.
DeepView moved(const DeepView& view, const glm::dvec2& offset);

}  // namespace kinescope
