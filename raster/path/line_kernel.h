// Anti-aliased lines in SIMD: eight pixels of a row, or four of two rows, at a time.
#pragma once

#include <cstdint>
#include <span>

#include "raster/image/image.h"
#include "raster/path/ink.h"
#include "raster/path/stroke.h"

namespace kinescope {

/// A line and its colour.
struct InkedLine {
  Segment segment;
  LinearRgba colour;
};

/// Draws lines[order[0]], lines[order[1]] ... into rows [y_begin, y_end) of the picture, exactly
/// as stroke_coverage() and ink::lay() do. Writes no pixel outside those rows.
void draw_lines(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                const Stroke& stroke, Mixing mixing, int y_begin, int y_end,
                Image<Linear8>& picture);
void draw_lines(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                const Stroke& stroke, Mixing mixing, int y_begin, int y_end,
                Image<LinearRgba>& picture);

}  // namespace kinescope
