// Pictures of a time of day, seconds from midnight: a clock's face, and the sun over hills.
#pragma once

#include "demos/lesson/world.h"
#include "raster/image/image.h"

namespace kinescope {

void paint_clock(Image<Srgb8>& paper, const World& world, double time);

/// The sun's height above the horizon as a share of its highest, which it has at noon.
double sun_height(double time);
/// @param noon_deg how high it stands then
void paint_sun(Image<Srgb8>& paper, const World& world, double time, double noon_deg);

}  // namespace kinescope
