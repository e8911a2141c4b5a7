// Names of pictures that are one film: frame_####.png.
#pragma once

#include <string>
#include <vector>

namespace kinescope {

/// "frame_####.png" and 7: "frame_0007.png". A name without # is returned as it is.
std::string numbered_name(const std::string& pattern, int number);

/// The files there are of such a pattern, by number, from the least to the greatest.
/// @throws Error (bad input) if there are none, or if a number between is missing
std::vector<std::string> numbered_files(const std::string& pattern);

}  // namespace kinescope
