#include "demos/tube_dials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kinescope {
namespace {

constexpr double kFlat = 1e-9;  // bulge below which a glass is flat, 1/mm

void times(double& setting, double factor) { setting *= factor; }
void add(double& setting, double more, double least, double most) {
  setting = std::clamp(setting + more, least, most);
}

/// A preset of unlimited bandwidth is limited in shares of what a pixel on, a pixel off asks for.
void turn_bandwidth(TubeSettings& s, double share) {
  if (s.gun.bandwidth_hz == 0 && share != 1) s.gun.bandwidth_hz = s.mode.pixel_clock_hz / 2;
  s.gun.bandwidth_hz *= share;
}

void turn_bulge(TubeSettings& s, double more_a_metre) {
  const double own = s.glass.curvature_mm > 0 ? 1 / s.glass.curvature_mm : 0;
  const double bulge = std::clamp(own + more_a_metre / 1000, 0.0, 1 / s.glass.diagonal_mm);
  s.glass.curvature_mm = bulge < kFlat ? 0 : 1 / bulge;
}

constexpr auto kRed = 0u, kBlue = 2u;

#define TURN(...) [](TubeSettings& s, double v) { __VA_ARGS__; }
constexpr std::array kDials{
    TubeDial{"brightness", "1", "2", -0.3, 0.3, 0.01, 0, "",
             "brightness, added to the video signal", TURN(add(s.gun.brightness, v, -1, 1))},
    TubeDial{"contrast", "3", "4", 0, 2, 0.05, 1, "x", "contrast, the video amplifier's gain",
             TURN(times(s.gun.contrast, v))},
    TubeDial{"bandwidth", "5", "6", 0.1, 2, 0.1, 1, "x", "how fast the video amplifier follows",
             turn_bandwidth},
    TubeDial{"focus", "7", "8", 0.5, 3, 0.1, 1, "x", "size of the spot, 1 being as it should be",
             TURN(times(s.spot.focus, v))},
    TubeDial{"bloom", "9", "0", 0, 0.4, 0.05, 0.4, "",
             "by how much the spot may shrink as the current falls",
             TURN(add(s.spot.least, 0.4 - v, 0.6, 1))},
    TubeDial{"astigmatism", ";", "'", 0.5, 2, 0.1, 1, "x", "the spot wider, or higher",
             TURN(times(s.spot.astigmatism, v))},
    TubeDial{"width", "q", "w", 0.5, 1.5, 0.01, 1, "x", "width of the raster on the glass",
             TURN(times(s.deflection.width, v))},
    TubeDial{"height", "e", "r", 0.5, 1.5, 0.01, 1, "x", "height of the raster on the glass",
             TURN(times(s.deflection.height, v))},
    TubeDial{"across", "Left", "Right", -0.3, 0.3, 0.01, 0, "", "moves the raster to the right",
             TURN(add(s.deflection.shift_x, v, -1, 1))},
    TubeDial{"down", "Up", "Down", -0.3, 0.3, 0.01, 0, "", "moves the raster down",
             TURN(add(s.deflection.shift_y, v, -1, 1))},
    TubeDial{"pincushion", "y", "u", -0.15, 0.15, 0.01, 0, "", "pulls the corners out",
             TURN(add(s.deflection.pincushion_x, v, -0.3, 0.3);
                  add(s.deflection.pincushion_y, v, -0.3, 0.3))},
    TubeDial{"keystone", "i", "o", -0.2, 0.2, 0.01, 0, "",
             "makes the raster wider below than above",
             TURN(add(s.deflection.keystone, v, -0.5, 0.5))},
    TubeDial{"rotation", "a", "d", -10, 10, 0.5, 0, "deg", "the yoke turned, clockwise",
             TURN(add(s.deflection.rotation_deg, v, -45, 45))},
    TubeDial{"s-curve", "f", "g", -0.2, 0.2, 0.01, 0, "", "slows the sweep at its ends",
             TURN(add(s.deflection.s_curve, v, -0.5, 0.5))},
    TubeDial{"red across", "h", "j", -3, 3, 0.05, 0, "mm", "moves the red beam to the right",
             TURN(add(s.deflection.convergence[kRed].x_mm, v, -20, 20))},
    TubeDial{"red down", "k", "l", -3, 3, 0.05, 0, "mm", "moves the red beam down",
             TURN(add(s.deflection.convergence[kRed].y_mm, v, -20, 20))},
    TubeDial{"blue across", "x", "c", -3, 3, 0.05, 0, "mm", "moves the blue beam to the right",
             TURN(add(s.deflection.convergence[kBlue].x_mm, v, -20, 20))},
    TubeDial{"blue down", "v", "b", -3, 3, 0.05, 0, "mm", "moves the blue beam down",
             TURN(add(s.deflection.convergence[kBlue].y_mm, v, -20, 20))},
    TubeDial{"pitch", "F1", "F2", 0.5, 8, 0.5, 1, "x", "from one triad of the mask to the next",
             TURN(times(s.mask.pitch_mm, v); times(s.mask.slot_mm, v))},
    TubeDial{"open", "F3", "F4", -0.5, 0.3, 0.05, 0, "", "how wide the mask's openings are",
             TURN(add(s.mask.open, v, 0.05, 1))},
    TubeDial{"bulge", "F5", "F6", -2, 2, 0.1, 0, "/m", "curves the glass: 1 over its radius",
             turn_bulge},
    TubeDial{"halation", "F7", "F8", -0.1, 0.4, 0.01, 0, "", "light that goes astray in the glass",
             TURN(add(s.glass.halation, v, 0, 0.5))},
    TubeDial{"ambient", "F9", "F10", 0, 0.3, 0.01, 0, "", "the room's light on the glass",
             TURN(add(s.glass.ambient, v, 0, 1))},
};
#undef TURN

}  // namespace

std::span<const TubeDial> tube_dials() { return kDials; }

TubeSettings magnified(TubeSettings s, double times) {
  s.glass.diagonal_mm /= times;
  // Of damper wires, only one in the middle stays in sight.
  if (times > 1) s.mask.wires = std::fmod(s.mask.wires, 2.0);
  DeflectionSettings& d = s.deflection;
  for (double* share : {&d.width, &d.height, &d.shift_x, &d.shift_y}) *share *= times;
  return s;
}

}  // namespace kinescope
