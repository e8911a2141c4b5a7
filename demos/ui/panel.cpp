#include "demos/ui/panel.h"

#include <algorithm>
#include <cmath>

#include "demos/ui/side.h"
#include "demos/ui/theme.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

constexpr float kGapAtTheSide = 18;  // so that the panel covers a lesson's

}  // namespace

/// Lays the panel out from top to bottom. Run once without a canvas to measure the height, and once
/// with it to draw. A dense one has each knob on one line.
class Panel::Painter {
 public:
  /// @param width in pixels
  Painter(const Studio& studio, float scale, float width, bool dense, Canvas* canvas = nullptr,
          std::vector<Target>* targets = nullptr)
      : studio_(studio),
        scale_(scale),
        width_(width),
        dense_(dense),
        canvas_(canvas),
        targets_(targets) {}

  float height(const DemoInfo& info, std::span<const Knob> knobs) {
    y_ = px(theme::kMargin);
    title(info);
    for (std::size_t i = 0; i < knobs.size(); ++i) dense_ ? line(i, knobs[i]) : row(i, knobs[i]);
    return y_ + px(theme::kMargin - theme::kGap);
  }

 private:
  float px(float size) const { return size * scale_; }
  float left() const { return px(theme::kMargin); }
  float right() const { return width_ - px(theme::kMargin); }

  void text(float x, float y, std::string_view words, float size, Srgb8 colour,
            Align align = Align::kLeft) {
    if (canvas_ != nullptr) {
      canvas_->text(studio_.sans, {x, y + px(size) * 0.36f}, words, px(size), colour, align);
    }
  }
  void fill(const Rect& rect, Srgb8 colour) {
    if (canvas_ != nullptr) {
      canvas_->fill(rect, colour, std::min(rect.height * 0.5f, px(theme::kRadius * 0.6f)));
    }
  }
  void target(const Rect& rect, std::size_t knob, double value) {
    if (targets_ != nullptr) targets_->push_back({rect, knob, value});
  }

  void title(const DemoInfo& info) {
    text(left(), y_ + px(10), info.name, theme::kTitle * 0.85f, theme::kText);
    y_ += px(32);
    for (const std::string& line :
         wrap(studio_.sans, info.summary, px(theme::kSmall), right() - left())) {
      text(left(), y_, line, theme::kSmall, theme::kDim);
      y_ += px(18);
    }
    y_ += px(4);
  }

  void row(std::size_t index, const Knob& knob) {
    fill({left(), y_, right() - left(), std::max(1.0f, px(1))}, theme::kRule);
    y_ += px(20);
    text(left(), y_, knob.name, theme::kBody, theme::kText);
    switch (knob.kind) {
      case KnobKind::kToggle:
        toggle(index, knob);
        break;
      case KnobKind::kChoice:
        if (knob.keys.size() == 1) keys(knob, right());
        y_ += px(28);
        chips(index, knob);
        break;
      case KnobKind::kNumber:
        number(index, knob);
        break;
    }
  }

  /// A knob on one line: name, track, value, keys. What is no number turns when it is clicked.
  void line(std::size_t index, const Knob& knob) {
    constexpr float kTrack = 64, kKeys = 68, kStep = 27;
    const float value = right() - px(kKeys);
    y_ += px(kStep * 0.5f);
    text(left(), y_, knob.name, theme::kSmall, theme::kText);
    text(value, y_, knob.text(), theme::kSmall, theme::kAccent, Align::kRight);
    keys(knob, right());
    if (knob.kind == KnobKind::kNumber) {
      const float room = studio_.sans.width_px("-0.55 mm", px(theme::kSmall));
      track(index, knob, {value - room - px(kTrack), y_ - px(1.5f), px(kTrack), px(3)});
    } else {
      const auto values = static_cast<int>(std::max<std::size_t>(2, knob.choices.size()));
      target({0, y_ - px(kStep * 0.5f), width_, px(kStep)}, index, (knob.index() + 1) % values);
    }
    y_ += px(kStep * 0.5f);
  }

  void keys(const Knob& knob, float end) {
    for (auto key = knob.keys.rbegin(); key != knob.keys.rend(); ++key) {
      end -= key_width(studio_, *key, px(theme::kSmall * 0.85f));
      if (canvas_ != nullptr) draw_key(*canvas_, studio_, end, y_, *key, px(theme::kSmall * 0.85f));
      end -= px(4);
    }
  }

  void toggle(std::size_t index, const Knob& knob) {
    const Rect track{right() - px(36), y_ - px(9), px(36), px(18)};
    if (canvas_ != nullptr) {
      canvas_->fill(track, knob.on() ? theme::kAccent : theme::kKeyCap, track.height * 0.5f);
      const float x = knob.on() ? track.right() - px(9) : track.x + px(9);
      canvas_->disc({x, y_}, px(6.5f), knob.on() ? theme::kAccentDark : theme::kDim);
    }
    keys(knob, track.x - px(10));
    target({0, y_ - px(18), width_, px(36)}, index, knob.on() ? 0 : 1);
    y_ += px(20);
  }

  void chips(std::size_t index, const Knob& knob) {
    float x = left();
    const float size = theme::kSmall;
    for (std::size_t i = 0; i < knob.choices.size(); ++i) {
      const bool has_key = knob.keys.size() > 1;
      const float cap =
          has_key ? studio_.sans.width_px(key_label(knob.keys[i]), px(size)) + px(7) : 0;
      const float width = studio_.sans.width_px(knob.choices[i], px(size)) + cap + px(18);
      if (x + width > right() && x > left()) x = left(), y_ += px(30);
      const Rect chip{x, y_ - px(12), width, px(24)};
      const bool chosen = static_cast<int>(i) == knob.index();
      fill(chip, chosen ? theme::kAccent : theme::kKeyCap);
      text(x + px(9), y_, knob.choices[i], size, chosen ? theme::kAccentDark : theme::kText);
      if (has_key) {
        text(chip.right() - px(9), y_, key_label(knob.keys[i]), size,
             chosen ? theme::kAccentDark : theme::kDim, Align::kRight);
      }
      target(chip, index, static_cast<double>(i));
      x += width + px(6);
    }
    y_ += px(22);
  }

  void number(std::size_t index, const Knob& knob) {
    keys(knob, right());
    const float caps = key_width(studio_, knob.keys[0], px(theme::kSmall * 0.85f)) +
                       key_width(studio_, knob.keys[1], px(theme::kSmall * 0.85f)) + px(14);
    text(right() - caps, y_, knob.text(), theme::kBody, theme::kAccent, Align::kRight);
    y_ += px(22);
    track(index, knob, {left(), y_ - px(2), right() - left(), px(4)});
    y_ += px(18);
  }

  void track(std::size_t index, const Knob& knob, const Rect& track) {
    const float share =
        static_cast<float>((knob.value - knob.minimum) / (knob.maximum - knob.minimum));
    fill(track, theme::kKeyCap);
    fill({track.x, track.y, track.width * share, track.height}, theme::kAccent);
    if (canvas_ != nullptr) {
      canvas_->disc({track.x + track.width * share, y_}, px(dense_ ? 5 : 6.5f), theme::kAccent);
    }
    // Each step has a place of its own along the track.
    const int steps = static_cast<int>(std::lround((knob.maximum - knob.minimum) / knob.step));
    const float width = track.width / static_cast<float>(steps);
    for (int i = 0; i <= steps; ++i) {
      const float middle = track.x + static_cast<float>(i) * width;
      const float from = std::max(track.x, middle - 0.5f * width);
      const float to = std::min(track.x + track.width, middle + 0.5f * width);
      target({from, y_ - px(10), to - from, px(20)}, index, knob.minimum + knob.step * i);
    }
  }

  const Studio& studio_;
  float scale_, width_;
  bool dense_;
  Canvas* canvas_;
  std::vector<Target>* targets_;
  float y_ = 0;
};

void Panel::lay(const DemoInfo& info, const Demo& demo, const Studio& studio, Image<Srgb8>& frame) {
  std::vector<double> values;
  for (const Knob& knob : demo.knobs()) values.push_back(knob.value);
  const bool fresh = values == values_ && frame_width_ == frame.width() &&
                     frame_height_ == frame.height() && !layer_.image.empty();
  if (!fresh) {
    values_ = std::move(values);
    frame_width_ = frame.width();
    frame_height_ = frame.height();
    float scale = theme::scale_for(frame.height());
    const float room = static_cast<float>(frame.height()) - 2 * theme::kMargin * scale;
    const float width =
        std::floor(side_width(frame.width(), frame.height()) - kGapAtTheSide * scale);
    float height = Painter(studio, scale, width, false).height(info, demo.knobs());
    const bool dense = height > room;
    if (dense) height = Painter(studio, scale, width, true).height(info, demo.knobs());
    if (height > room) {
      scale *= room / height;
      height = Painter(studio, scale, width, true).height(info, demo.knobs());
    }
    layer_ = begin_layer(static_cast<int>(width), static_cast<int>(std::ceil(height)));
    Canvas canvas(layer_.image);
    targets_.clear();
    Painter(studio, scale, width, dense, &canvas, &targets_).height(info, demo.knobs());
    finish_layer(layer_, theme::kRadius * scale);
    layer_.x = frame.width() - layer_.image.width() - static_cast<int>(theme::kMargin * scale);
    layer_.y = static_cast<int>(theme::kMargin * scale);
  }
  composite(layer_, frame);
}

bool Panel::contains(int x, int y) const {
  return layer_.image.contains(x - layer_.x, y - layer_.y);
}

std::vector<std::string> Panel::click(int x, int y, std::span<const Knob> knobs, bool drag) const {
  const auto hit = std::find_if(targets_.begin(), targets_.end(), [&](const Target& target) {
    return target.rect.contains(static_cast<float>(x - layer_.x), static_cast<float>(y - layer_.y));
  });
  if (hit == targets_.end()) return {};
  const Knob& knob = knobs[hit->knob];
  if (drag && knob.kind != KnobKind::kNumber) return {};
  return knob.keys_to(knob.kind == KnobKind::kToggle ? 1 - knob.value : hit->value);
}

}  // namespace kinescope
