// How a tube's light is cut into the frames of a window.
#pragma once

#include <optional>
#include <string>

#include "raster/base/units.h"

namespace kinescope {

struct WindowPace {
  Seconds tick{0};      ///< from one frame of the window to the next
  Seconds exposure{0};  ///< of each picture; the next one begins where it ends
  int ticks = 1;        ///< a picture each so many: it is shown in the first, black in the others
  std::string remark;   ///< why it is not as asked, or empty
};

/// Without a shutter each frame of the window shows a refresh. A shutter makes slices: each is
/// shown for one frame of the monitor, and black until the next begins, so the monitor's frames
/// must fit into it a whole number of times; else whole refreshes are shown, with a remark.
/// @param monitor frames a second. @param refresh of the tube
WindowPace window_pace(std::optional<Seconds> shutter, Rate monitor, Rate refresh);

}  // namespace kinescope
