// What a picture's claimed size must satisfy before memory is taken for it.
#pragma once

#include <cstdint>
#include <string>

namespace kinescope {

/// @param max_pixels the most that the compressed bytes at hand can possibly hold
/// @throws Error (bad input) on a side or an area that is zero or too large
void check_image_size(std::int64_t width, std::int64_t height, std::int64_t max_pixels,
                      const std::string& name);

}  // namespace kinescope
