// What the video sends while a sweep that does not follow it draws a line.
#pragma once

#include <span>
#include <vector>

#include "display/frame_buffer.h"
#include "display/raster_scan.h"

namespace kinescope {

/// Gun drive of each cell of a line: of the pixel that the video sends in the cell's middle; black
/// in its blanking. Video clocks, from the tube's time 0.
/// @param first_clock in the middle of the first cell
/// @param step from one cell to the next
/// @param line work space, a line of the mode
void read_video(const RasterScan& scan, const FrameBuffer& buffer, double first_clock, double step,
                std::vector<GunDrive>& line, std::span<GunDrive> drives);

}  // namespace kinescope
