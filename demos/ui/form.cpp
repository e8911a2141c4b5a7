#include "demos/ui/form.h"

#include <algorithm>
#include <numeric>

#include "demos/ui/theme.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

constexpr float kRow = 17, kTableRow = 16, kControl = 24, kPadding = 8, kGap = 7;

}  // namespace

Form::Form(Canvas& canvas, const Studio& studio, float scale, const Rect& area)
    : canvas_(canvas), studio_(studio), scale_(scale), area_(area), y_(area.y) {}

float Form::row_height() const { return px(kRow); }

void Form::words(float x, std::string_view text, float size, Srgb8 colour, Align align) {
  canvas_.text(studio_.sans, {x, y_ + px(size) * 0.36f}, text, px(size), colour, align);
}

void Form::title(std::string_view text) {
  y_ += px(12);
  words(area_.x, text, theme::kTitle * 0.8f, theme::kText, Align::kLeft);
  y_ += px(18);
}

void Form::text(std::string_view text, Srgb8 colour) {
  for (const std::string& line : wrap(studio_.sans, text, px(theme::kSmall), area_.width)) {
    y_ += px(kRow / 2);
    words(area_.x, line, theme::kSmall, colour, Align::kLeft);
    y_ += px(kRow / 2);
  }
}

void Form::code(std::string_view text, Srgb8 colour) {
  y_ += px(kRow);
  canvas_.text(studio_.mono, {area_.x, y_ - px(4)}, text, px(theme::kSmall), colour);
}

void Form::field(int id, std::string_view label, std::string_view shown, const TextField* field) {
  const Rect box{area_.x + area_.width * 0.34f, y_, area_.width * 0.66f, px(kControl)};
  y_ += px(kControl / 2);
  words(area_.x, label, theme::kSmall, theme::kDim, Align::kLeft);
  canvas_.fill(box, theme::kBackground, px(4));
  canvas_.frame(box, std::max(1.0f, px(1)), field ? theme::kAccent : theme::kKeyCap, px(4));
  const std::string_view text = field ? std::string_view(field->text) : shown;
  const glm::vec2 at(box.x + px(kPadding), y_ + px(theme::kSmall) * 0.36f);
  canvas_.text(studio_.mono, at, text, px(theme::kSmall), theme::kText);
  if (field) {
    const float x = at.x + studio_.mono.width_px(text.substr(0, field->caret), px(theme::kSmall));
    canvas_.fill({x, box.y + px(4), std::max(1.0f, px(1.5f)), box.height - px(8)}, theme::kAccent);
  }
  targets_.push_back({box, id});
  y_ += px(kControl / 2 + 5);
}

void Form::slider(int id, float share) {
  const Rect track{area_.x + area_.width * 0.34f, y_ + px(5), area_.width * 0.66f, px(4)};
  share = std::clamp(share, 0.0f, 1.0f);
  canvas_.fill(track, theme::kKeyCap, px(2));
  canvas_.fill({track.x, track.y, track.width * share, track.height}, theme::kAccent, px(2));
  canvas_.disc({track.x + track.width * share, track.y + px(2)}, px(6), theme::kAccent);
  targets_.push_back({{track.x, y_ - px(2), track.width, px(18)}, id});
  y_ += px(18);
}

void Form::buttons(const std::vector<Button>& row) {
  float x = area_.x;
  for (const Button& button : row) {
    const float width = studio_.sans.width_px(button.label, px(theme::kSmall)) + px(2 * kPadding);
    if (x + width > area_.right() && x > area_.x) {
      x = area_.x;
      y_ += px(kControl + 4);
    }
    const Rect box{x, y_, width, px(kControl)};
    canvas_.fill(box, button.lit ? theme::kAccent : theme::kKeyCap, px(5));
    canvas_.text(studio_.sans, {x + width / 2, y_ + px(kControl / 2) + px(theme::kSmall) * 0.36f},
                 button.label, px(theme::kSmall), button.lit ? theme::kAccentDark : theme::kText,
                 Align::kCentre);
    targets_.push_back({box, button.id});
    x += width + px(5);
  }
  y_ += px(kControl + 6);
}

/// Where the columns end: each is as wide as what stands in it, and has its share of what is left.
std::vector<float> Form::column_ends(const Table& table, std::size_t shown, float& size) const {
  std::vector<float> ends;
  for (const std::string& name : table.columns) ends.push_back(studio_.mono.width_px(name, size));
  for (std::size_t row = table.rows.size() - shown; row < table.rows.size(); ++row) {
    for (std::size_t i = 0; i < std::min(ends.size(), table.rows[row].size()); ++i) {
      ends[i] = std::max(ends[i], studio_.mono.width_px(table.rows[row][i], size));
    }
  }
  const float room = area_.width - px(4), gaps = px(kGap) * static_cast<float>(ends.size());
  const float needed = std::accumulate(ends.begin(), ends.end(), 0.0f);
  const float shrunk = std::min(1.0f, room / std::max(needed + gaps, 0.01f));
  size *= shrunk;
  const float gap = (room - needed * shrunk) / static_cast<float>(ends.size());
  float end = area_.x;
  for (float& width : ends) width = end += width * shrunk + gap;
  return ends;
}

void Form::table(const Table& table, float bottom) {
  const auto count = table.columns.size();
  if (count == 0) return;
  const float room = std::max(0.0f, bottom - y_ - px(kTableRow)) / std::max(px(kTableRow), 0.01f);
  const auto shown = std::min(table.rows.size(), static_cast<std::size_t>(room));
  if (shown == 0 && !table.rows.empty()) return;  // names alone tell nothing
  float size = px(theme::kSmall * 0.95f);
  const std::vector<float> ends = column_ends(table, shown, size);
  const auto line = [&](const std::vector<std::string>& cells, Srgb8 colour) {
    y_ += px(kTableRow);
    for (std::size_t i = 0; i < std::min(count, cells.size()); ++i) {
      canvas_.text(studio_.mono, {ends[i], y_ - px(4)}, cells[i], size, colour, Align::kRight);
    }
  };
  line(table.columns, theme::kDim);
  for (std::size_t i = table.rows.size() - shown; i < table.rows.size(); ++i) {
    const bool marked = i < table.marked.size() && table.marked[i];
    const bool last = i + 1 == table.rows.size();
    line(table.rows[i], marked ? theme::kRed : last ? theme::kAccent : theme::kText);
  }
}

}  // namespace kinescope
