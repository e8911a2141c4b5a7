// Stereo sound as an oscilloscope in XY mode shows it: the left channel moves the beam across, the
// right one up. Source: IBM and Microsoft, Multimedia Programming Interface 1.0, 1991 (RIFF WAVE).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "display/vector/input/drawing.h"

namespace kinescope {

/// 8, 16, 24 or 32 bits or floats, two channels or more (the first two count). Units of the drawing
/// are those of 16 bits, -32768 to 32767 either way, on a square screen. One stroke a sample
/// period, whose current is the same: the longer, the dimmer; up to a 512th of the screen's width
/// it has full intensity. Data that is cut off is drawn as far as it goes.
/// @param name what an Error calls the data
/// @throws Error (bad input)
VectorDrawing read_wav(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace kinescope
