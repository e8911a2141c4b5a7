#include "demos/ui/hud.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "demos/ui/theme.h"

namespace kinescope {

void Hud::lay(const Content& content, const Studio& studio, Image<Srgb8>& frame) {
  const bool fresh = content_ == content && frame_width_ == frame.width() &&
                     frame_height_ == frame.height() && !layer_.image.empty();
  if (!fresh) {
    content_ = content;
    frame_width_ = frame.width();
    frame_height_ = frame.height();
    draw(studio, frame.width(), frame.height());
  }
  composite(layer_, frame);
}

void Hud::draw(const Studio& studio, int, int height) {
  const float scale = theme::scale_for(height);
  const float size = theme::kSmall * scale, pad = theme::kGap * scale;
  std::vector<std::pair<std::string, Srgb8>> words = {{content_.name, theme::kText}};
  words.emplace_back(content_.time_scale,
                     content_.time_scale == "1x" ? theme::kDim : theme::kAccent);
  if (content_.paused) {
    words.emplace_back("paused", theme::kAccent);
  } else {
    words.emplace_back(fmt::format("{} frames/s", content_.frames_per_second), theme::kDim);
  }
  if (content_.message.empty()) {
    words.emplace_back(content_.has_knobs ? "Tab knobs" : "Tab hides this", theme::kDim);
    words.emplace_back("? keys", theme::kDim);
  } else {
    words.emplace_back(content_.message, theme::kAccent);
  }
  float width = pad;
  for (const auto& [word, colour] : words) width += studio.sans.width_px(word, size) + 2 * pad;
  const float line = studio.sans.line_height_px(size) + pad;
  layer_ = begin_layer(static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(line)));
  Canvas canvas(layer_.image);
  const float baseline = pad * 0.5f + studio.sans.ascent_px(size);
  float x = 1.5f * pad;
  for (const auto& [word, colour] : words) {
    canvas.text(studio.sans, {x, baseline}, word, size, colour);
    x += studio.sans.width_px(word, size) + 2 * pad;
  }
  finish_layer(layer_, line * 0.5f);
  layer_.x = static_cast<int>(theme::kMargin * scale);
  layer_.y = height - static_cast<int>(theme::kMargin * scale) - layer_.image.height();
}

}  // namespace kinescope
