// Display presets by name. Data: demos/data/displays.txt.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "display/raster_tube.h"

namespace kinescope {

struct DisplayPreset {
  std::string name, mode, phosphor, note;
  TubeSettings settings() const;
};

/// In the order of the table; the first is the default.
std::span<const DisplayPreset> display_presets();
/// @throws Error (usage) naming the presets there are
const DisplayPreset& find_display(std::string_view name);

}  // namespace kinescope
