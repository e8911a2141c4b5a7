// How a lesson looks: the panel beside the picture, and what lies over the picture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "demos/lesson/lesson.h"
#include "demos/ui/side.h"
#include "demos/ui/theme.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

constexpr std::size_t kMostLit = 256;  // pixels of a step: fewer have a frame around each

/// Nothing of a value that is none.
std::string cell(double value) {
  if (std::isnan(value)) return "";
  if (value == std::floor(value) && std::abs(value) < 1e9) return fmt::format("{:.0f}", value);
  // Great numbers leave decimals out, so that columns stay apart.
  const double size = std::abs(value);
  return fmt::format("{:.{}f}", value, size < 100 ? 3 : size < 1000 ? 2 : 1);
}

}  // namespace

Rect Lesson::side() const {
  const float margin = theme::kMargin * theme::scale_for(height());
  const auto w = static_cast<float>(width()), h = static_cast<float>(height());
  if (portrait()) return {w, 0, 0, h};
  const float across = std::floor(std::min(side_width(width(), height()), w * 0.4f));
  return {w - across, 0, across, h - std::floor(std::min(margin, h * 0.01f))};
}

Rect Lesson::stage() const {
  // A thumbnail's picture keeps most of its height.
  const float scale = theme::scale_for(height()), h = static_cast<float>(height());
  if (portrait()) return {0, 0, side().x, h};
  const float room = h - std::min(kHintRoom * scale, 0.4f * h);
  const float gap = std::min(theme::kGap * scale, 0.1f * std::min(side().x, room));
  return Rect{0, 0, side().x, room}.shrunk(gap);
}

void Lesson::draw_fields(Form& form) const {
  const auto field = [&](std::size_t i, const std::string& label) {
    const int number = static_cast<int>(i);
    form.field(kFirstField + number, label, shown_in_field(number),
               focus_ == number ? &field_ : nullptr);
  };
  // Many corners are shown in the picture; their fields would fill the panel.
  constexpr std::size_t kMostFields = 4;
  const std::size_t points = plan_.handles.size();
  for (std::size_t i = 0, shown = 0; i < points && shown < kMostFields; ++i) {
    if (!handle_shown(static_cast<int>(i))) continue;
    field(i, plan_.handles[i].label);
    ++shown;
  }
  for (std::size_t i = 0; i < plan_.figures.size(); ++i) {
    const Figure& f = plan_.figures[i];
    field(points + i, f.label);
    form.slider(kFirstSlider + static_cast<int>(i),
                static_cast<float>((f.value - f.least) / (f.most - f.least)));
  }
  if (plan_.words) field(static_cast<std::size_t>(fields()) - 1, plan_.words->label);
  if (!typing_fault_.empty()) form.text(typing_fault_, theme::kRed);
  if (!fault_.empty()) form.text(fault_, theme::kRed);
}

void Lesson::draw_menu(Form& form) const {
  for (int i = 0; i < own_knobs_; ++i) {
    const Knob& k = knob(i);
    const int id = kFirstChoice + i * 100;
    std::vector<Form::Button> row;
    if (k.kind == KnobKind::kToggle) row.push_back({id, k.name, k.on()});
    if (k.kind == KnobKind::kChoice) {
      for (int c = 0; c < static_cast<int>(k.choices.size()); ++c) {
        row.push_back({id + c, k.choices[static_cast<std::size_t>(c)], c == k.index()});
      }
    }
    if (!row.empty()) form.buttons(row);
  }
  const bool runs = knob(own_knobs_ + 3).on();
  form.buttons({{kRestart, "|<"},
                {kBack, "<"},
                {kRun, runs ? "hold" : "run", runs},
                {kNext, ">"},
                {kEnd, ">|"}});
}

/// The state of one track up to now; of two with few columns each, side by side.
Form::Table Lesson::table(const Track& track, const Track* beside) const {
  Form::Table table;
  table.columns = {"step"};
  const auto add = [&](const Track& t) {
    table.columns.insert(table.columns.end(), t.columns().begin(), t.columns().end());
  };
  add(track);
  if (beside) add(*beside);
  const std::size_t steps = std::max(track.steps(), beside ? beside->steps() : 0);
  const std::size_t end = std::min(playback_.shown(), steps);
  constexpr std::size_t kMostRows = 64;
  for (std::size_t i = end - std::min(end, kMostRows); i < end; ++i) {
    std::vector<std::string> row = {fmt::format("{}", i)};
    const auto cells = [&](const Track& t) {
      for (std::size_t c = 0; c < t.columns().size(); ++c) {
        row.push_back(i < t.steps() ? cell(t.values(i)[c]) : "");
      }
    };
    cells(track);
    if (beside) cells(*beside);
    table.rows.push_back(std::move(row));
    const auto differs = [&](const Track& other) {
      if (i >= track.steps() || i >= other.steps()) return true;
      const auto a = track.marks(i), b = other.marks(i);
      return !std::equal(a.begin(), a.end(), b.begin(), b.end(),
                         [](const Mark& p, const Mark& q) { return p.x == q.x && p.y == q.y; });
    };
    table.marked.push_back(beside && course_->compare && differs(*beside));
  }
  return table;
}

void Lesson::draw_state(Form& form) const {
  const float bottom = side().height - theme::kMargin * theme::scale_for(height());
  const auto& tracks = course_->tracks;
  form.text(
      fmt::format("step {} of {}, {}", playback_.shown(), steps(), knob(own_knobs_ + 2).text()),
      theme::kAccent);
  for (const std::string& remark : course_->remarks) form.text(remark, theme::kText);
  constexpr std::size_t kMostColumns = 6;
  const bool together =
      tracks.size() == 2 && tracks[0].columns().size() + tracks[1].columns().size() <= kMostColumns;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Track& track = tracks[i];
    const Track* beside = together ? &tracks[1] : nullptr;
    form.gap(4);
    form.text(beside ? track.name() + " | " + beside->name() : track.name(), theme::kCool);
    const std::size_t now = std::min(playback_.shown(), track.steps());
    if (now > 0) {
      std::istringstream note(track.note(now - 1));
      for (std::string line; std::getline(note, line) && form.y() + form.row_height() < bottom;) {
        form.code(line, theme::kText);
      }
    }
    const auto left = static_cast<float>(together ? 1 : tracks.size() - i);
    if (!track.columns().empty() || beside) {
      form.table(table(track, beside), form.y() + (bottom - form.y()) / left);
    }
    if (together) break;
  }
}

void Lesson::draw_side() {
  if (portrait()) return;
  const Rect room = side();
  auto sheet = std::make_shared<Sheet>();
  sheet->image = Image<Srgb8>(static_cast<int>(room.width), static_cast<int>(room.height),
                              theme::with_alpha(theme::kPanel, 255));
  Canvas canvas(sheet->image);
  const float scale = theme::scale_for(height());
  Form form(canvas, studio(), scale,
            Rect{0, 0, room.width, room.height}.shrunk(theme::kMargin * scale * 0.75f));
  draw_fields(form);
  draw_menu(form);
  draw_state(form);
  sheet->targets = form.targets();
  sheet_ = std::move(sheet);
}

/// A pane's guides and words, and the handles that may be dragged in it.
void Lesson::draw_pane(Canvas& canvas, const World& world, int pane, const Overlay& over) const {
  const float scale = theme::scale_for(height());
  const auto place = [&](glm::dvec2 at) { return screen_.place(world, {pane, at}); };
  const glm::vec2 corner = place({0, 0});
  const glm::vec2 room =
      glm::vec2(screen_.face().width, screen_.face().height) / glm::vec2(world.panes);
  canvas.set_clip({corner.x, corner.y, room.x, room.y});
  for (const std::vector<Guide>* guides : {&course_->guides, &over.guides}) {
    for (const Guide& guide : *guides) {
      if (guide.pane >= 0 && guide.pane != pane) continue;
      canvas.line(place(guide.from), place(guide.to), 1.5f * scale, guide.colour);
    }
  }
  for (const Label& label : over.labels) {
    if (label.pane != pane) continue;
    const float size = theme::kSmall * scale;
    const float half = studio().sans.width_px(label.words, size) / 2 + 3 * scale;
    const glm::vec2 at = place(label.at);
    canvas.fill({at.x - half, at.y - size * 0.6f, 2 * half, size * 1.2f},
                theme::with_alpha(theme::kBackground, 235), 3 * scale);
    canvas.text(studio().sans, at + glm::vec2(0, size * 0.36f), label.words, size, label.colour,
                Align::kCentre);
  }
  for (std::size_t i = 0; i < plan_.handles.size(); ++i) {
    if (!handle_in(static_cast<int>(i), pane)) continue;
    const glm::vec2 at = place(plan_.handles[i].at + 0.5);
    canvas.disc(at, 8.5f * scale, theme::with_alpha(theme::kBackground, 150));
    canvas.disc(at, 7 * scale, theme::with_alpha(theme::kAccent, 150));
    canvas.disc(at, 3 * scale, theme::kAccentDark);
  }
  canvas.set_clip(screen_.face());
  if (pane % world.panes.x) {
    canvas.line(corner, {corner.x, screen_.face().bottom()}, 2 * scale, theme::kDim);
  }
  if (pane >= world.panes.x) {
    canvas.line(corner, {screen_.face().right(), corner.y}, 2 * scale, theme::kDim);
  }
}

/// The pixels of the last step, each in a frame, and the tracks' names where there are several.
void Lesson::draw_marks(Canvas& canvas, const World& world) const {
  if (portrait()) return;
  const float scale = theme::scale_for(height());
  const float pixel = screen_.face().width * static_cast<float>(world.cell) / World::kScreenWidth;
  for (const Track& track : course_->tracks) {
    const std::size_t now = playback_.shown();
    if (now == 0 || now > track.steps()) continue;
    const auto marks = track.marks(now - 1);
    if (marks.size() > kMostLit) continue;
    for (const Mark& mark : marks) {
      if (!world.window().contains({mark.x, mark.y, mark.x + 1, mark.y + 1})) continue;
      const glm::vec2 at = screen_.place(world, {track.pane(), {mark.x, mark.y}});
      canvas.frame({at.x, at.y, pixel, pixel}, 2 * scale, theme::kAccent);
    }
  }
  const int panes = world.panes.x * world.panes.y;
  std::vector<int> named(static_cast<std::size_t>(panes));  // tracks of a pane, one below another
  for (const Track& track : course_->tracks) {
    if (panes == 1) break;
    const glm::vec2 at = screen_.place(world, {track.pane(), {0, 0}});
    const int above = named[static_cast<std::size_t>(track.pane())]++;
    const float size = theme::kSmall * scale, line = 17 * scale;
    const float wide = studio().sans.width_px(track.name(), size) + 12 * scale;
    canvas.fill({at.x, at.y + static_cast<float>(above) * line, wide, line + 6 * scale},
                theme::kPanel);
    canvas.text(studio().sans, at + glm::vec2(6 * scale, static_cast<float>(1 + above) * line),
                track.name(), size, track.ink() == theme::kKeyCap ? theme::kDim : track.ink());
  }
}

/// What lies over the picture, and the line below it.
void Lesson::draw_over(Canvas& canvas) const {
  const World world = this->world();
  const Overlay over = course_->overlay ? course_->overlay(playback_.shown()) : Overlay{};
  canvas.set_clip(screen_.face());
  for (int pane = 0; pane < world.panes.x * world.panes.y; ++pane) {
    draw_pane(canvas, world, pane, over);
  }
  draw_marks(canvas, world);
  canvas.clear_clip();
  if (portrait()) return;
  const float scale = theme::scale_for(height());
  const float left = theme::kMargin * scale, size = theme::kBody * scale;
  const auto lines = wrap(studio().sans, plan_.look_for, size, side().x - 2 * left);
  // There is room for two; where the window is narrow, more begin higher.
  const float step = size * 1.25f, more = std::max(0.0f, static_cast<float>(lines.size()) - 2);
  float y = static_cast<float>(height()) - (kHintRoom - 20) * scale - more * step;
  for (const std::string& line : lines) {
    canvas.text(studio().sans, {left, y}, line, size, theme::kDim);
    y += step;
  }
  const LessonScreen::Spot spot = screen_.spot(world, mouse_.x, mouse_.y);
  if (screen_.face().contains(static_cast<float>(mouse_.x), static_cast<float>(mouse_.y))) {
    const glm::dvec2 at = world.named(glm::floor(spot.at));
    const std::string words = fmt::format("({:.0f}, {:.0f})", at.x, at.y);
    const float small = theme::kSmall * scale, pad = 6 * scale;
    const float wide = studio().mono.width_px(words, small) + 2 * pad;
    const Rect face = screen_.face();
    canvas.fill({face.right() - wide, face.y, wide, 23 * scale}, theme::kPanel);
    canvas.text(studio().mono, {face.right() - pad, face.y + 17 * scale}, words, small,
                theme::kCool, Align::kRight);
  }
}

}  // namespace kinescope
