// The demos there are. A new one is a file of its own and a line in registry.cpp.
#pragma once

#include <span>
#include <string_view>

#include "demos/demo.h"

namespace kinescope {

/// In the order of the gallery; the first is the default.
std::span<const DemoInfo> all_demos();

/// @throws Error (usage) naming the known ones
const DemoInfo& find_demo(std::string_view name);

}  // namespace kinescope
