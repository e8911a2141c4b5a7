// The strip at a window's right where a demo's own panel stands, and the panel of knobs over it.
#pragma once

#include <algorithm>

#include "demos/ui/form.h"
#include "demos/ui/theme.h"

namespace kinescope {

inline constexpr float kHintRoom = 86;  ///< below a lesson's picture, with the window's own line

/// Pixels. In a wide window it has some of the room that a picture of 4 to 3 leaves.
inline float side_width(int width, int height) {
  const float scale = theme::scale_for(height), least = Form::kWidth * scale;
  const float picture = (static_cast<float>(height) - kHintRoom * scale) * 4 / 3;
  return std::clamp(static_cast<float>(width) - picture, least, 1.25f * least);
}

}  // namespace kinescope
