// SVG drawings as strokes: groups, transforms, nested and referred-to parts (use, symbol), all
// shapes and path commands, strokes with their widths, dashes and colours, simple style sheets, and
// text in our own stroke font. Shapes that are only filled are drawn as outlines. Not read: clips,
// masks, markers, gradients, filters, patterns, pictures.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "display/vector/input/drawing.h"

namespace kinescope {

/// Units of the drawing are the picture's CSS pixels, y upwards. Curves lie within a twentieth of
/// one of their chords.
/// @param name what an Error calls the data
/// @throws Error (bad input)
VectorDrawing read_svg(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace kinescope
