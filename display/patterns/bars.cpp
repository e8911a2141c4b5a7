// Colour bars. Sources: SMPTE EG 1-1990; EIA-189-A; ITU-R BT.471-1.
#include <array>

#include "display/patterns/areas.h"
#include "display/patterns/patterns.h"

namespace kinescope {
namespace {

/// Which guns are on, in the order of falling luminance.
struct Guns {
  bool r, g, b;
};
constexpr std::array kBars{Guns{true, true, true},  Guns{true, true, false},
                           Guns{false, true, true}, Guns{false, true, false},
                           Guns{true, false, true}, Guns{true, false, false},
                           Guns{false, false, true}};
constexpr Guns kOff{false, false, false};
// From the left, each below the bar whose blue it equals.
constexpr std::array kCastellations{kBars[6], kOff, kBars[4], kOff, kBars[2], kOff, kBars[0]};

Srgb8 driven(Guns guns, double level) {
  const auto code = [&](bool on) { return drive_code(on ? level : 0); };
  return {code(guns.r), code(guns.g), code(guns.b), 255};
}

constexpr double kSevenths = 1.0 / 7, kBarLevel = 0.75;
constexpr double kSignal_ire = 92.5;  // white over black, above the setup of 7.5

/// Drive of a colour without luminance whose subcarrier is as large as the burst, 20 IRE. I and Q
/// lie 33 degrees ahead of the colour differences (SMPTE 170M).
Srgb8 without_luminance(double i_ire, double q_ire) {
  const double i = i_ire / kSignal_ire, q = q_ire / kSignal_ire;
  const double angle = 33 * 3.14159265358979323846 / 180;
  // U = 0.492111 (B' - Y'), V = 0.877283 (R' - Y').
  const double u = -i * std::sin(angle) + q * std::cos(angle);
  const double v = i * std::cos(angle) + q * std::sin(angle);
  const double b = u / 0.492111, r = v / 0.877283;
  return {drive_code(r), drive_code(-(0.299 * r + 0.114 * b) / 0.587), drive_code(b), 255};
}

void draw_foot(Image<Srgb8>& picture) {
  const double top = 0.75, patch = 5.0 / 4 * kSevenths, step = kSevenths / 3;
  const auto fill = [&](double left, double width, Srgb8 colour) {
    fill_area(picture, {left, top, left + width, 1}, colour);
  };
  fill(0, patch, without_luminance(-20, 0));
  fill(patch, patch, grey_drive(1));
  fill(2 * patch, patch, without_luminance(0, 20));
  // PLUGE: 4 IRE below black, black, 4 IRE above.
  const double pluge = 5 * kSevenths;
  fill(pluge, step, grey_drive(-4 / kSignal_ire));
  fill(pluge + step, step, grey_drive(0));
  fill(pluge + 2 * step, step, grey_drive(4 / kSignal_ire));
}

}  // namespace

Image<Srgb8> smpte_bars(int width, int height) {
  constexpr double kBarsEnd = 2.0 / 3, kCastellationsEnd = 0.75;
  Image<Srgb8> picture(width, height);
  for (std::size_t i = 0; i < kBars.size(); ++i) {
    const double left = static_cast<double>(i) * kSevenths;
    const double right = static_cast<double>(i + 1) * kSevenths;
    fill_area(picture, {left, 0, right, kBarsEnd}, driven(kBars[i], kBarLevel));
    fill_area(picture, {left, kBarsEnd, right, kCastellationsEnd},
              driven(kCastellations[i], kBarLevel));
  }
  draw_foot(picture);
  return picture;
}

Image<Srgb8> ebu_bars(int width, int height) {
  Image<Srgb8> picture(width, height);
  for (std::size_t i = 0; i < kBars.size(); ++i) {
    const double left = static_cast<double>(i) / 8, right = static_cast<double>(i + 1) / 8;
    fill_area(picture, {left, 0, right, 1}, driven(kBars[i], i == 0 ? 1 : kBarLevel));
  }
  return picture;
}

}  // namespace kinescope
