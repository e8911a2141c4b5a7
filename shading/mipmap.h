// One level of a mipmap chain from the next larger one: the exact mean over each texel's area.
#pragma once

#include "shading/texture.h"

namespace kinescope {

/// Row y of `to`, whose sides are half of those of `from`, rounded down but at least 1.
void average_row(const Texture::Level& from, const Texture::Level& to, int y, Texel* out);

}  // namespace kinescope
