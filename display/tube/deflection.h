// Where the beam lands: from its sweep, across and down, to a place on the glass, and back.
#pragma once

#include "display/tube/settings.h"

namespace kinescope {

/// A place as shares of half a width and half a height from the middle: -1 left or top, 1 right or
/// bottom. Of the sweep (its active part), the glass, or the camera's picture.
struct Place {
  double x = 0, y = 0;
};

/// Output pixels a millimetre of glass that fills the output.
struct PixelsAMm {
  double across = 0, down = 0;
};
PixelsAMm pixels_a_mm(const GlassSettings& glass, int width, int height);

class Deflection {
 public:
  /// @param gun 0 red, 1 green, 2 blue
  Deflection(const DeflectionSettings& settings, const GlassSettings& glass, int gun);

  /// Where on the glass the beam lands at a place of its sweep.
  Place glass_of_sweep(Place sweep) const;
  /// Its inverse, by Newton's method.
  Place sweep_of_glass(Place glass) const;

 private:
  DeflectionSettings d_;
  ConvergenceError error_;
  double half_width_mm_, half_height_mm_;
  double cos_, sin_;
};

/// Whether a sweep lands in straight, upright lines, its two axes apart: then the picture can be
/// spread along one axis after the other.
bool is_separable(const TubeSettings& settings);

/// The camera looks at the middle of the glass from in front. A curved faceplate bulges towards it.
class GlassCamera {
 public:
  explicit GlassCamera(const GlassSettings& glass);
  /// The place on the glass that a place of the camera's picture shows: places on a curved glass
  /// are measured along it.
  Place glass_of_picture(Place picture) const;
  /// Its inverse.
  Place picture_of_glass(Place glass) const;

 private:
  double along_glass(double slope) const;

  double half_width_mm_, half_height_mm_, radius_mm_, distance_mm_;
  double scale_;
};

}  // namespace kinescope
