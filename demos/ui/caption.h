// A line of text at the foot of a demo's picture, clear of the window's own line below it.
#pragma once

#include <string_view>

#include "demos/ui/canvas.h"

namespace kinescope {

/// What a caption takes of a picture's height, with the window's line, pixels.
float caption_room(int height);
void lay_caption(Image<Srgb8>& picture, const Font& font, std::string_view text);

}  // namespace kinescope
