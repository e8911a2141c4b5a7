// What a lesson's user does: keys, handles that are dragged, controls and fields of the panel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "demos/lesson/lesson.h"
#include "raster/base/error.h"

namespace kinescope {

/// @return whether the input changed
bool Lesson::take(const InputEvent& event) {
  stale_ = true;
  if (typing() && (event.kind == InputKind::kKeyDown || event.kind == InputKind::kText)) {
    return take_typed(event);
  }
  if (event.kind == InputKind::kMouseDown || event.kind == InputKind::kMouseMove ||
      event.kind == InputKind::kMouseUp) {
    return take_mouse(event);
  }
  if (event.kind == InputKind::kKeyDown) {
    if (event.key == "n") return use(kNext, 0);
    if (event.key == "b") return use(kBack, 0);
    if (event.key == "Home") return use(kRestart, 0);
    if (event.key == "End") return use(kEnd, 0);
  }
  return answer(event, screen_.spot(world(), event.x, event.y));
}

bool Lesson::take_mouse(const InputEvent& event) {
  mouse_ = {event.x, event.y};
  if (event.kind == InputKind::kMouseUp && (held_ != kNoHandle || held_slider_ >= 0)) {
    const bool moved = held_ != kNoHandle;
    held_ = kNoHandle;
    held_slider_ = -1;
    return moved;  // now it is played from its start
  }
  bool typed = false;
  if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kLeft) {
    typed = leave_field();
    if (side().contains(static_cast<float>(event.x), static_cast<float>(event.y))) {
      return press(event.x, event.y) || typed;
    }
    held_ = handle_near(event);
    held_pane_ = screen_.spot(world(), event.x, event.y).pane;
    if (held_ != kNoHandle) return typed;
  }
  if (event.kind == InputKind::kMouseMove && held_slider_ >= 0) return press(event.x, event.y);
  if (event.kind == InputKind::kMouseMove && held_ != kNoHandle) {
    const LessonScreen::Spot spot = screen_.spot_in(world(), held_pane_, event.x, event.y);
    move_handle(static_cast<std::size_t>(held_), glm::floor(spot.at));
    return true;
  }
  return answer(event, screen_.spot(world(), event.x, event.y)) || typed;
}

/// What was typed is taken when the mouse goes elsewhere. @return whether it changed the input
bool Lesson::leave_field() {
  if (!typing() || !accept()) return false;
  const bool changed = !field_.text.empty() && !types_words();  // words are taken letter by letter
  focus_ = kNoField;
  return changed;
}

void Lesson::move_handle(std::size_t handle, glm::dvec2 to) {
  const glm::dvec2 way = to - plan_.handles[handle].at;
  for (Handle& other : plan_.handles) {
    if (other.follows == static_cast<int>(handle)) other.at += way;
  }
  plan_.handles[handle].at = to;
}

/// Of fields: a figure's is always there.
bool Lesson::handle_shown(int handle) const {
  if (handle >= static_cast<int>(plan_.handles.size())) return true;
  bool shown = false;
  const glm::ivec2 grid = panes();
  for (int pane = 0; pane < grid.x * grid.y; ++pane) shown |= handle_in(handle, pane);
  return shown;
}

int Lesson::handle_near(const InputEvent& event) const {
  const int pane = screen_.spot(world(), event.x, event.y).pane;
  const glm::vec2 mouse(event.x, event.y);
  float nearest = 26 * theme::scale_for(height());
  int found = kNoHandle;
  for (std::size_t i = 0; i < plan_.handles.size(); ++i) {
    if (!handle_in(static_cast<int>(i), pane)) continue;
    const glm::vec2 place = screen_.place(world(), {pane, plan_.handles[i].at + 0.5});
    const float distance = glm::length(place - mouse);
    if (distance < nearest) nearest = distance, found = static_cast<int>(i);
  }
  return found;
}

bool Lesson::press(int x, int y) {
  const Rect room = side();
  const glm::vec2 at(static_cast<float>(x) - room.x, static_cast<float>(y) - room.y);
  for (const Form::Target& target : sheet_->targets) {
    const bool held = held_slider_ == target.id;
    if (!held && !target.rect.contains(at.x, at.y)) continue;
    if (held_slider_ >= 0 && !held) continue;
    return use(target.id, std::clamp((at.x - target.rect.x) / target.rect.width, 0.0f, 1.0f));
  }
  return false;
}

bool Lesson::use(int control, float along) {
  const int run = running_knob();
  if (control >= kFirstChoice) {
    const int index = (control - kFirstChoice) / 100;
    turn(index, knob(index).kind == KnobKind::kToggle ? 1 - knob(index).value
                                                      : (control - kFirstChoice) % 100);
    return true;
  }
  if (control >= kFirstSlider) {
    held_slider_ = control;
    Figure& f = plan_.figures[static_cast<std::size_t>(control - kFirstSlider)];
    const double value = f.least + static_cast<double>(along) * (f.most - f.least);
    f.value = f.least + f.step * std::round((value - f.least) / f.step);
    return true;
  }
  if (control >= kFirstField) {
    focus_on(control - kFirstField);
    return false;
  }
  if (control == kRun) {
    if (playback_.shown() == steps() && knob(run).on()) {
      playback_.go_to(0);
    } else {
      turn(run, knob(run).on() ? 0 : 1);
    }
    return false;
  }
  if (control == kRestart) playback_.go_to(0);
  if (control == kEnd) playback_.go_to(steps());
  if (control == kNext || control == kBack) {
    turn(run, 0);
    playback_.step_by(control == kNext ? 1 : -1, steps());
  }
  return false;
}

int Lesson::fields() const {
  return static_cast<int>(plan_.handles.size() + plan_.figures.size()) + (plan_.words ? 1 : 0);
}

bool Lesson::types_words() const { return typing() && plan_.words && focus_ == fields() - 1; }

void Lesson::focus_on(int field) {
  focus_ = field;
  field_.set(types_words() ? plan_.words->text : "");
  typing_fault_.clear();
}

std::string Lesson::shown_in_field(int field) const {
  const auto i = static_cast<std::size_t>(field);
  if (i >= plan_.handles.size() + plan_.figures.size()) return words();
  if (i >= plan_.handles.size()) {
    return fmt::format("{:.6g}", plan_.figures[i - plan_.handles.size()].value);
  }
  const glm::dvec2 at = world().named(plan_.handles[i].at);
  return fmt::format("{:.10g}, {:.10g}", at.x, at.y);
}

/// Enter accepts, Escape leaves the input as it was, Tab goes to the next field.
bool Lesson::take_typed(const InputEvent& event) {
  if (event.kind == InputKind::kKeyDown && event.key == "Escape") {
    focus_ = kNoField;
    typing_fault_.clear();
    return false;
  }
  const bool tab = event.key == "Tab";
  if (event.kind == InputKind::kKeyDown && (event.key == "Return" || tab)) {
    const bool changed = !field_.text.empty();
    if (!accept()) return false;
    if (tab) {
      do {
        focus_on((focus_ + 1) % fields());
      } while (!handle_shown(focus_));
    } else {
      focus_ = kNoField;
    }
    return changed;
  }
  field_.answer(event);
  if (!types_words() || plan_.words->text == field_.text) return false;
  plan_.words->text = field_.text;
  return true;
}

/// Takes what was typed; an empty field keeps what was there. @return whether it could be read
bool Lesson::accept() {
  typing_fault_.clear();
  if (field_.text.empty() || types_words()) return true;
  const auto i = static_cast<std::size_t>(focus_);
  const bool point = i < plan_.handles.size();
  try {
    const std::vector<double> typed = typed_numbers(field_.text, point ? 2 : 1);
    if (point) {
      move_handle(i, world().of_name({typed[0], typed[1]}));
    } else {
      plan_.figures[i - plan_.handles.size()].value = typed[0];
    }
    return true;
  } catch (const Error& error) {
    const std::string& label =
        point ? plan_.handles[i].label : plan_.figures[i - plan_.handles.size()].label;
    typing_fault_ = label + ": " + error.what();
    return false;
  }
}

}  // namespace kinescope
