// Pictures for a colour table: each pixel a value in [0, 1) along it.
#pragma once

#include <cstdint>
#include <functional>

#include "display/frame_buffer.h"
#include "raster/base/units.h"

namespace kinescope {

using StoreValue = std::function<void(int x, int y, float value)>;

/// Clouds of added sines; the seed turns and shifts them.
void paint_plasma(int width, int height, std::uint64_t seed, const StoreValue& store);
/// Rings round a few centres, as waves that cross.
void paint_rings(int width, int height, std::uint64_t seed, const StoreValue& store);
/// A ball that bounces between pillars, at a time.
void paint_ball(int width, int height, Seconds now, const StoreValue& store);

/// A colour along a closed path through colour space; `place` counts rounds.
/// @param palette 0 warm and blue, 1 green and violet
GunDrive table_colour(double place, int palette);

}  // namespace kinescope
