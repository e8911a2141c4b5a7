// Pieces that panels and help share: key caps, wrapped text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "demos/studio.h"
#include "demos/ui/canvas.h"

namespace kinescope {

/// How a key is written on its cap: "Left" is an arrow.
std::string key_label(const std::string& key);
/// Draws a key's cap with its left end at x, centred on y. @return its width, pixels
float draw_key(Canvas& canvas, const Studio& studio, float x, float y, const std::string& key,
               float size);
float key_width(const Studio& studio, const std::string& key, float size);

/// Breaks text at spaces so that each line is at most `width` pixels wide.
std::vector<std::string> wrap(const Font& font, std::string_view text, float size, float width);

}  // namespace kinescope
