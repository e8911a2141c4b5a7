// HP-GL, the language of Hewlett-Packard's pen plotters, and the vector part of HP-GL/2.
// Read: AA AR AT BL BP BR BZ CI CO CP DF DI DR DT DV EA EP ER ES EW FP FR FT IN IP IW LB LO LT NP
// PA PB PC PD PG PM PR PT PU PW RA RO RR RT SC SI SL SM SP SR TL WG WU XT YT AF AH. Passed over:
// instructions that draw nothing (VS, CS, LA, OI ...), escapes, and PE (polylines in their own
// code), with a warning.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "display/vector/input/drawing.h"
#include "raster/base/error.h"

namespace kinescope {

/// Units of the drawing are the plotter's, 1/40 mm; it shows what was drawn, with a little margin.
/// @param name what an Error calls the data
/// @param warnings if given, receives what was not understood
/// @throws Error (bad input) if nothing in it is an instruction
VectorDrawing read_hpgl(std::span<const std::uint8_t> bytes, const std::string& name,
                        Warnings* warnings = nullptr);

}  // namespace kinescope
