// A straight piece of the beam's way, and what light it leaves: the integral over time of a moving
// Gaussian spot, over the area of each pixel.
#pragma once

#include <array>

namespace kinescope {

/// A round Gaussian spot moving evenly from one place to another, pixels. Pixel (x, y) is
/// [x, x + 1) x [y, y + 1). What it leaves adds up to 1, wherever it lies.
struct BeamStroke {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  float sigma = 1;  ///< standard deviation; drawn as at least kLeastSigma
};

/// Spots at rest, pixels, whose sum stands for the light of a beam that speeds up, bends or changes
/// its current: Gauss's rule over a time in which it goes a way of a few deviations.
struct BeamSpots {
  static constexpr int kMost = 6;
  int count = 0;
  std::array<float, kMost> x{}, y{}, sigma{}, share{};
};

/// A spot narrower than a tenth of a pixel looks like one of this width.
inline constexpr float kLeastSigma = 0.1f;
/// Deviations from its middle at which a spot is cut off.
inline constexpr float kSpotReach = 4;

/// The share of a stroke's light that falls on pixel (x, y): the readable scalar twin of the
/// kernel. Within a thousandth of the largest share, whatever the width, length and direction.
double stroke_share(const BeamStroke& stroke, int x, int y);

/// The same of spots, within 5e-4 of the largest share.
double spots_share(const BeamSpots& spots, int x, int y);

}  // namespace kinescope
