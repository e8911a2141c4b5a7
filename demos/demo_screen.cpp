#include "demos/demo_screen.h"

#include <utility>

#include "raster/base/error.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

constexpr int kMessageTicks = 180;

InputEvent key_press(const std::string& key) {
  InputEvent event;
  event.kind = InputKind::kKeyDown;
  event.key = key;
  return event;
}

bool is_mouse(InputKind kind) {
  return kind == InputKind::kMouseMove || kind == InputKind::kMouseDown ||
         kind == InputKind::kMouseUp || kind == InputKind::kWheel;
}

}  // namespace

DemoScreen::DemoScreen(const DemoInfo& info, const DemoSetup& setup)
    : info_(info),
      studio_(setup.studio),
      player_(info, setup),
      transport_(info.time_scale),
      frame_(setup.width, setup.height) {}

void DemoScreen::handle(const InputEvent& event) {
  if (event.kind == InputKind::kKeyDown && !typing() &&
      (own_key(event.key, event.repeated) || transport_.answer(event.key, event.repeated))) {
    dirty_ = true;
    return;
  }
  if (is_mouse(event.kind) && show_panel_ && !show_help_ && panel_mouse(event)) return;
  if (event.kind == InputKind::kResize) {
    // While a window is dragged larger, only its latest size counts.
    std::erase_if(waiting_, [](const InputEvent& e) { return e.kind == InputKind::kResize; });
    waiting_.push_back(usable_size(event));
    return;
  }
  waiting_.push_back(event);
}

bool DemoScreen::own_key(const std::string& key, bool repeated) {
  const bool save_key = key == "s" || key == "S";
  if (key != "Tab" && key != "?" && !save_key) return false;
  if (repeated) return true;
  if (key == "Tab") show_panel_ = !show_panel_;
  if (key == "?") show_help_ = !show_help_;
  if (save_key) save();
  return true;
}

/// @return whether the event belongs to the panel
bool DemoScreen::panel_mouse(const InputEvent& event) {
  if (event.kind == InputKind::kMouseDown && panel_.contains(event.x, event.y)) {
    panel_holds_mouse_ = true;
  }
  const bool inside = panel_.contains(event.x, event.y);
  const bool turns = event.kind == InputKind::kMouseDown || event.kind == InputKind::kMouseMove;
  if (panel_holds_mouse_ && turns) {
    // Keys already on their way to the demo count, so that a dragged slider does not overshoot.
    std::vector<Knob> knobs(player_.demo().knobs().begin(), player_.demo().knobs().end());
    for (const InputEvent& e : waiting_) {
      for (Knob& knob : knobs) {
        if (e.kind == InputKind::kKeyDown && knob.answer(e.key, e.repeated)) break;
      }
    }
    const bool drag = event.kind == InputKind::kMouseMove;
    for (const std::string& key : panel_.click(event.x, event.y, knobs, drag)) {
      waiting_.push_back(key_press(key));
    }
  }
  if (event.kind == InputKind::kMouseUp) return std::exchange(panel_holds_mouse_, false);
  return panel_holds_mouse_ || (inside && event.kind == InputKind::kWheel);
}

void DemoScreen::say(const std::string& message) {
  message_ = message;
  message_ticks_ = kMessageTicks;
  dirty_ = true;
}

void DemoScreen::save() {
  try {
    const std::string name = free_picture_name(info_.name);
    write_png(name, player_.picture());
    say("saved " + name);
  } catch (const Error& error) {
    say(error.what());
  }
}

bool DemoScreen::move() {
  switch (transport_.next()) {
    case Move::kNone:
      return false;
    case Move::kForward:
      player_.forward(transport_.step_length(player_.demo().refresh()),
                      std::exchange(waiting_, {}));
      return !player_.demo().still();
    case Move::kBack:
      if (info_.steps_back) return player_.back();
      say("its past is not kept: there is no stepping back");
      return false;
  }
  return false;
}

bool DemoScreen::idle() const {
  if (dirty_ || message_ticks_ > 0 || transport_.steps_once()) return false;
  return transport_.paused() || (waiting_.empty() && player_.demo().still());
}

bool DemoScreen::tick(int frames_per_second) {
  const bool moved = move();
  if (message_ticks_ > 0 && --message_ticks_ == 0) message_.clear(), dirty_ = true;
  const bool rate_shown = shown_rate_ == frames_per_second || player_.demo().still();
  if (!moved && !dirty_ && rate_shown) return false;
  dirty_ = false;
  compose(frames_per_second);
  return true;
}

void DemoScreen::compose(int frames_per_second) {
  const Image<Srgb8>& picture = player_.picture();
  frame_.resize(picture.width(), picture.height());
  run_rows(studio_->workers, picture.height(),
           [&](int y) { std::copy_n(picture.row(y), picture.width(), frame_.row(y)); });
  shown_rate_ = frames_per_second;
  if (show_panel_ && !show_help_) panel_.lay(info_, player_.demo(), *studio_, frame_);
  if (show_help_) help_.lay(info_, player_.demo().knobs(), *studio_, frame_);
  hud_.lay({std::string(info_.name), transport_.text(), frames_per_second, transport_.paused(),
            message_},
           *studio_, frame_);
}

}  // namespace kinescope
