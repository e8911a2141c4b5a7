// A staircase of drive.
#include "display/patterns/areas.h"
#include "display/patterns/patterns.h"

namespace kinescope {

Image<Srgb8> grey_steps(int width, int height) {
  constexpr int kSteps = 11;
  Image<Srgb8> picture(width, height);
  for (int i = 0; i < kSteps; ++i) {
    const double left = 1.0 * i / kSteps, right = 1.0 * (i + 1) / kSteps;
    fill_area(picture, {left, 0, right, 0.5}, grey_drive(i / 10.0));
    fill_area(picture, {left, 0.5, right, 1}, grey_drive((10 - i) / 10.0));
  }
  return picture;
}

}  // namespace kinescope
