#include "demos/ui/help.h"

#include <algorithm>
#include <cmath>

#include "demos/ui/theme.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

struct Entry {
  std::vector<std::string> keys;  // none: a heading
  std::string help;
};

std::vector<Entry> entries(const DemoInfo& info, std::span<const Knob> knobs) {
  std::vector<Entry> list = {{{}, std::string(info.name)}};
  if (!info.mouse.empty()) list.push_back({{"mouse"}, std::string(info.mouse)});
  for (const Knob& knob : knobs) list.push_back({knob.keys, knob.help});
  const std::vector<Entry> time = {{{}, "time"},
                                   {{"Space"}, "pause and go on"},
                                   {{".", ","}, "one step forward, one step back"},
                                   {{"[", "]"}, "slow time down to 1/100000, and up again"},
                                   {{}, "window"}};
  const std::vector<Entry> window = {{{"?"}, "these keys"},
                                     {{"S"}, "save the picture here as a PNG file"},
                                     {{"F11"}, "full screen"},
                                     {{"Escape"}, "leave full screen, then the window"}};
  list.insert(list.end(), time.begin(), time.end());
  list.push_back({{"Tab"}, knobs.empty() ? "the line of state" : "the panel of knobs"});
  list.insert(list.end(), window.begin(), window.end());
  return list;
}

float keys_width(const Studio& studio, const Entry& entry, float size) {
  float width = 0;
  for (const std::string& key : entry.keys) width += key_width(studio, key, size) + size * 0.3f;
  return width;
}

Layer draw(const std::vector<Entry>& list, const Studio& studio, float scale) {
  const float size = theme::kBody * scale, row = size * 1.85f,
              margin = theme::kMargin * 1.5f * scale;
  const float cap = theme::kSmall * scale;
  float keys = 0, words = 0;
  for (const Entry& entry : list) {
    keys = std::max(keys, keys_width(studio, entry, cap));
    words = std::max(words, studio.sans.width_px(entry.help, size));
  }
  const float indent = margin + keys + theme::kMargin * scale;
  const auto rows = static_cast<float>(list.size());
  Layer layer = begin_layer(static_cast<int>(indent + words + margin),
                            static_cast<int>(std::ceil(rows * row + 1.5f * margin)));
  Canvas canvas(layer.image);
  float y = margin * 0.75f + row * 0.5f;
  for (const Entry& entry : list) {
    float x = margin;
    for (const std::string& key : entry.keys) {
      x += draw_key(canvas, studio, x, y, key, cap) + cap * 0.3f;
    }
    const bool heading = entry.keys.empty();
    canvas.text(studio.sans, {heading ? margin : indent, y + size * 0.36f}, entry.help, size,
                heading ? theme::kAccent : theme::kText);
    y += row;
  }
  finish_layer(layer, theme::kRadius * scale);
  return layer;
}

}  // namespace

void Help::lay(const DemoInfo& info, std::span<const Knob> knobs, const Studio& studio,
               Image<Srgb8>& frame) {
  if (layer_.image.empty() || frame_width_ != frame.width() || frame_height_ != frame.height()) {
    frame_width_ = frame.width();
    frame_height_ = frame.height();
    const std::vector<Entry> list = entries(info, knobs);
    // A long list shrinks to fit.
    const float natural = static_cast<float>(list.size() + 2) * theme::kBody * 1.85f;
    const float room = static_cast<float>(frame.height()) * 0.94f / natural;
    layer_ = draw(list, studio, std::min(theme::scale_for(frame.height()), room));
    layer_.x = (frame.width() - layer_.image.width()) / 2;
    layer_.y = (frame.height() - layer_.image.height()) / 2;
  }
  composite(layer_, frame);
}

}  // namespace kinescope
