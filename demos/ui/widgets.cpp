#include "demos/ui/widgets.h"

#include <algorithm>
#include <map>

#include "demos/ui/theme.h"

namespace kinescope {

std::string key_label(const std::string& key) {
  static const std::map<std::string, std::string> kLabels = {
      {"Left", "\u2190"}, {"Right", "\u2192"}, {"Up", "\u2191"},
      {"Down", "\u2193"}, {"Escape", "Esc"},   {"Return", "Enter"}};
  const auto found = kLabels.find(key);
  return found == kLabels.end() ? key : found->second;
}

float key_width(const Studio& studio, const std::string& key, float size) {
  return std::max(studio.sans.width_px(key_label(key), size) + size * 0.8f, size * 1.6f);
}

float draw_key(Canvas& canvas, const Studio& studio, float x, float y, const std::string& key,
               float size) {
  const float width = key_width(studio, key, size);
  const Rect cap{x, y - size * 0.8f, width, size * 1.6f};
  canvas.fill(cap, theme::kKeyCap, size * 0.3f);
  canvas.text(studio.sans, {x + width * 0.5f, y + size * 0.36f}, key_label(key), size, theme::kText,
              Align::kCentre);
  return width;
}

std::vector<std::string> wrap(const Font& font, std::string_view text, float size, float width) {
  if (!(size > 0)) return {};
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || font.width_px(longer, size) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace kinescope
