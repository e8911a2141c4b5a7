// A picture reduced to a palette, as a lesson's course: the boxes of its colours as they are cut,
// and what their mean colours make of it.
#pragma once

#include "demos/lesson/lesson.h"

namespace kinescope {

/// Four panes of the picture's size: the picture, the palette, the nearest colours, and diffused.
/// @param colours 2 to 256
Course palette_course(const Image<Srgb8>& picture, int colours);

}  // namespace kinescope
