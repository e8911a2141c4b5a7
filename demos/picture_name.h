// Names of pictures that a window saves.
#pragma once

#include <string>
#include <string_view>

namespace kinescope {

/// The first of kinescope-NAME-0001.png, -0002 ... that does not exist in the current folder.
std::string free_picture_name(std::string_view name);

}  // namespace kinescope
