// What a window of time holds for the cells of one scan line.
#pragma once

#include <array>

#include "display/phosphor_layer.h"
#include "display/raster_scan.h"

namespace kinescope {

/// The cells of a line in a window at most a frame long: those whose last excitation lies in the
/// frame that has begun when the window opens, and those of the frame before; of each, first those
/// that the window excites again. Some ranges may be empty.
using LineRanges = std::array<CellRange, 4>;
LineRanges line_ranges(const RasterScan& scan, BeamTime begin, BeamTime end, int line);

/// Lines that one task of a worker takes.
constexpr int kLinesATask = 8;
constexpr int line_tasks(int lines) { return (lines + kLinesATask - 1) / kLinesATask; }

}  // namespace kinescope
