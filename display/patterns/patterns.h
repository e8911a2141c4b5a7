// Test patterns, as the gun drive that a generator would send: no gamma correction lies between.
#pragma once

#include <span>
#include <string_view>

#include "raster/image/image.h"

namespace kinescope {

/// Each draws a picture of gun drive: its channels are R'G'B', 0 black to 255 white. Signals below
/// black, which no frame buffer holds, are black.
struct TestPattern {
  std::string_view name, note;
  Image<Srgb8> (*draw)(int width, int height);
};

/// SMPTE EG 1-1990 (EIA-189-A): 75% bars; blue castellations; -I, white, +Q and PLUGE.
Image<Srgb8> smpte_bars(int width, int height);
/// ITU-R BT.471 and EBU: 100/0/75/0, a white bar of 100%, coloured bars of 75%, black.
Image<Srgb8> ebu_bars(int width, int height);
/// Stripes just above and just below black beside steps up to white.
Image<Srgb8> pluge(int width, int height);
/// White lines, one pixel wide, that cut a 4:3 face into 16 by 12 squares; one ends each side.
Image<Srgb8> crosshatch(int width, int height);
/// A zone plate, circular on a 4:3 face: its rings are two pixels apart at the middle of the left
/// and right sides, or of top and bottom where that comes first.
Image<Srgb8> zone_plate(int width, int height);
/// Eleven steps of drive, 0 to 100% by 10%, rising above and falling below.
Image<Srgb8> grey_steps(int width, int height);
/// A white dot, two pixels wide and high, where the crosshatch's lines would cross.
Image<Srgb8> convergence_dots(int width, int height);

std::span<const TestPattern> test_patterns();
/// @throws Error (usage) naming the patterns there are
const TestPattern& find_test_pattern(std::string_view name);

}  // namespace kinescope
