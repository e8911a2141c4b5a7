// What the video sends while a sweep that does not follow it draws a line.
#pragma once

#include <span>
#include <vector>

#include "display/frame_buffer.h"
#include "display/raster_scan.h"
#include "display/tube/gun.h"

namespace kinescope {

/// Whether composite sync is at its tips at a clock of the frame: a pulse a line, and in vertical
/// sync two broad pulses a line, with gaps as long as a line's pulse. Equalizing pulses are left
/// out.
bool in_sync_tip(const VideoMode& mode, double frame_clock);

/// Gun drive of each cell of a line: of the pixel that the video sends in the cell's middle; black
/// in its blanking. Video clocks, from the tube's time 0.
/// @param first_clock in the middle of the first cell
/// @param step from one cell to the next
/// @param line work space, a line of the mode
void read_video(const RasterScan& scan, const FrameBuffer& buffer, double first_clock, double step,
                std::vector<GunDrive>& line, std::span<GunDrive> drives);
/// Those of the cells at which it sends its sync tips.
void find_sync_tips(const VideoMode& mode, double first_clock, double step, int cells,
                    std::vector<CellSpan>& tips);

}  // namespace kinescope
