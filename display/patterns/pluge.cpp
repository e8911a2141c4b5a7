// PLUGE: picture line-up generating equipment. Sources: ITU-R BT.814-4 for the levels about black
// (48, 64, 80 and white 940, 10 bits); the steps to white are those of the Quantum Data 780C
// (720, 560, 448, 360). Derived: where the areas lie.
#include <array>

#include "display/patterns/areas.h"
#include "display/patterns/patterns.h"

namespace kinescope {
namespace {

/// Drive of a 10-bit code of limited range.
double drive_of(int code) { return (code - 64) / 876.0; }

}  // namespace

Image<Srgb8> pluge(int width, int height) {
  constexpr int kDarker = 48, kLighter = 80;
  constexpr std::array kSteps{940, 720, 560, 448, 360};
  Image<Srgb8> picture(width, height);
  fill_area(picture, {0.15, 0.1, 0.22, 0.9}, grey_drive(drive_of(kDarker)));
  fill_area(picture, {0.30, 0.1, 0.37, 0.9}, grey_drive(drive_of(kLighter)));
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const double top = 0.1 + 0.16 * static_cast<double>(i);
    fill_area(picture, {0.6, top, 0.8, top + 0.16}, grey_drive(drive_of(kSteps[i])));
  }
  return picture;
}

}  // namespace kinescope
