#include "demos/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "demos/registry.h"
#include "demos/ui/theme.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

constexpr float kNotch = 0.7f;  // of a row, that the wheel scrolls

}  // namespace

Gallery::Gallery(std::shared_ptr<Studio> studio, int width, int height, std::uint64_t seed)
    : studio_(std::move(studio)),
      seed_(seed),
      page_(all_demos(), width, height),
      portraits_(all_demos().size()),
      width_(width),
      height_(height) {}

std::optional<std::size_t> Gallery::selected() const {
  if (page_.shown().empty()) return std::nullopt;
  return page_.shown()[place_];
}

void Gallery::select(std::size_t place, bool scroll) {
  place_ = place;
  if (scroll && place < page_.shown().size()) page_.reveal(place);
  dirty_ = true;
}

void Gallery::search() {
  page_.find(search_.text);
  select(0, true);
}

/// @return whether the key was one of those that move the mark
bool Gallery::move(const std::string& key) {
  const std::size_t count = page_.shown().size();
  const auto chapters = page_.chapters();
  const std::size_t chapter = page_.chapter_of(place_);
  if (key == "Left") {
    select(place_ > 0 ? place_ - 1 : 0, true);
  } else if (key == "Right") {
    select(std::min(place_ + 1, count - 1), true);
  } else if (key == "Up" || key == "Down") {
    select(page_.beside(place_, key == "Up" ? -1 : 1), true);
  } else if (key == "PageUp" || key == "PageDown") {
    select(page_.beside(place_, page_.rows_in_view() * (key == "PageUp" ? -1 : 1)), true);
  } else if (key == "Home") {
    select(0, true);
  } else if (key == "End") {
    select(count - 1, true);
  } else if (key == "Tab") {
    const std::size_t next = (chapter + 1) % chapters.size();
    page_.scroll_to_chapter(next);
    select(chapters[next].first, true);
  } else {
    return false;
  }
  return true;
}

/// @return whether the key is not the search's
bool Gallery::key(const std::string& key) {
  if (key == "Escape") {
    search_.set("");
    search();
    return true;
  }
  if (page_.shown().empty()) return false;
  if (key == "Return") {
    chosen_ = selected();
    return true;
  }
  return move(key);
}

void Gallery::press(int x, int y) {
  if (const auto chapter = page_.chapter_at(x, y)) {
    page_.scroll_to_chapter(*chapter);
    select(page_.chapters()[*chapter].first, false);
  }
  const auto hit = page_.place_at(x, y);
  if (hit) chosen_ = page_.shown()[*hit];
}

void Gallery::handle(const InputEvent& event) {
  switch (event.kind) {
    case InputKind::kKeyDown:
      if (key(event.key)) return;
      if (search_.answer(event)) search();
      break;
    case InputKind::kText:
      // A space begins no search: it would look as if there were none.
      if (!search_.text.empty() || event.key != " ") search_.answer(event), search();
      break;
    case InputKind::kMouseMove:
      if (const auto hit = page_.place_at(event.x, event.y); hit && *hit != place_) {
        select(*hit, false);
      }
      break;
    case InputKind::kMouseDown:
      press(event.x, event.y);
      break;
    case InputKind::kWheel:
      page_.scroll_by(-event.wheel * kNotch * page_.row_height());
      dirty_ = true;
      break;
    case InputKind::kResize:
      width_ = usable_size(event).x;
      height_ = usable_size(event).y;
      page_.resize(width_, height_);
      for (Portrait& portrait : portraits_) portrait = Portrait();
      select(place_, true);
      break;
    default:
      break;
  }
}

std::optional<std::size_t> Gallery::take_choice() {
  dirty_ = true;
  const auto shown = page_.shown();
  for (std::size_t i = 0; chosen_ && i < shown.size(); ++i) {
    if (shown[i] == *chosen_) select(i, true);
  }
  return std::exchange(chosen_, std::nullopt);
}

bool Gallery::in_view(std::size_t place) const {
  const Rect rect = page_.thumbnail(place), room = page_.room();
  return rect.bottom() > room.y && rect.y < room.bottom();
}

/// The marked demo's, or what the page begins with.
std::size_t Gallery::chapter_in_view() const {
  if (page_.shown().empty()) return 0;
  if (in_view(place_)) return page_.chapter_of(place_);
  std::size_t chapter = 0;
  const float top = page_.room().y + page_.heading(0).height;
  while (chapter + 1 < page_.chapters().size() && page_.heading(chapter + 1).y < top) ++chapter;
  return chapter;
}

void Gallery::step_portrait(std::size_t place) {
  const std::size_t index = page_.shown()[place];
  const Rect rect = page_.thumbnail(place);
  Portrait& portrait = portraits_[index];
  if (!portrait.begun()) {
    portrait = Portrait(all_demos()[index], {studio_, static_cast<int>(rect.width),
                                             static_cast<int>(rect.height), seed_});
  }
  portrait.step();
}

void Gallery::show_portrait(std::size_t place) {
  const Image<Srgb8>& picture = portraits_[page_.shown()[place]].picture();
  const Rect rect = page_.thumbnail(place);
  const int left = static_cast<int>(rect.x), top = static_cast<int>(rect.y);
  const int width = std::min(picture.width(), width_ - left);
  const int first = static_cast<int>(page_.room().y);
  for (int y = std::max(0, first - top); y < std::min(picture.height(), height_ - top); ++y) {
    std::copy_n(picture.row(y), std::max(0, width), frame_.row(top + y) + left);
  }
}

bool Gallery::tick(int) {
  if (std::exchange(dirty_, false)) draw_page();
  if (page_.shown().empty()) return true;
  if (in_view(place_)) {
    step_portrait(place_);
    show_portrait(place_);
  }
  // The others come one a tick, so that the first page is there at once.
  for (std::size_t i = 0; i < page_.shown().size(); ++i) {
    if (i == place_ || !in_view(i)) continue;
    if (!portraits_[page_.shown()[i]].unfinished()) continue;
    step_portrait(i);
    show_portrait(i);
    break;
  }
  return true;
}

void Gallery::draw_page() {
  frame_ = Image<Srgb8>(width_, height_, theme::kBackground);
  Canvas canvas(frame_);
  draw_header(canvas);
  draw_rail(canvas);
  canvas.set_clip(page_.room());
  const float size = theme::kTitle * 0.85f * page_.scale();
  for (std::size_t i = 0; i < page_.chapters().size(); ++i) {
    const Rect rect = page_.heading(i);
    canvas.text(studio_->sans, {rect.x, rect.y + rect.height * 0.66f}, page_.chapters()[i].name,
                size, theme::kCool);
  }
  for (std::size_t i = 0; i < page_.shown().size(); ++i) {
    if (!page_.room().contains(page_.room().x, page_.cell(i).y) && !in_view(i)) continue;
    draw_caption(i, canvas);
    if (!portraits_[page_.shown()[i]].picture().empty()) show_portrait(i);
  }
  if (page_.shown().empty()) {
    canvas.text(
        studio_->sans, {page_.room().x + 24 * page_.scale(), page_.room().y + 3 * size},
        fmt::format("No demo's name, chapter or topic holds \"{}\". Esc shows all.", search_.text),
        theme::kBody * page_.scale(), theme::kText);
  }
}

/// The title, what is searched for, and which keys there are.
void Gallery::draw_header(Canvas& canvas) const {
  const Rect header = page_.header();
  const float scale = page_.scale(), margin = 22 * scale, size = theme::kBody * scale;
  const float baseline = header.height * 0.6f, title = theme::kTitle * 1.25f * scale;
  const Font& font = studio_->sans;
  canvas.text(font, {margin, baseline}, "Kinescope", title, theme::kText);
  const float left =
      std::max(page_.rail().right() + margin, 2 * margin + font.width_px("Kinescope", title));
  const Rect box{left, header.height * 0.26f, std::min(430 * scale, header.width - left - margin),
                 header.height * 0.5f};
  if (box.width <= 0) return;
  const bool searching = !search_.text.empty();
  canvas.fill(box, theme::kKeyCap, 6 * scale);
  canvas.frame(box, std::max(1.0f, 1.5f * scale), searching ? theme::kAccent : theme::kDim,
               6 * scale);
  canvas.set_clip(box);
  const glm::vec2 at(box.x + 12 * scale, baseline - 2 * scale);
  canvas.text(font, searching ? at : at + glm::vec2(6 * scale, 0),
              searching ? std::string_view(search_.text) : "type to search names, topics, chapters",
              size, searching ? theme::kText : theme::kDim);
  const float caret = font.width_px(search_.text.substr(0, search_.caret), size);
  canvas.fill(
      {at.x + caret, box.y + 7 * scale, std::max(1.0f, 1.5f * scale), box.height - 14 * scale},
      theme::kAccent);
  canvas.clear_clip();
  const std::string keys = searching
                               ? fmt::format("{} of {} demos    Enter starts    Esc shows all",
                                             page_.shown().size(), all_demos().size())
                               : "arrows, wheel    Tab: next chapter    Enter starts    Esc leaves";
  const float room = header.width - box.right() - 2 * margin;
  const float small = font.width_px(keys, size) > room ? theme::kSmall * scale : size;
  if (font.width_px(keys, small) > room) return;
  canvas.text(font, {header.width - margin, baseline - 2 * scale}, keys, small, theme::kDim,
              Align::kRight);
}

void Gallery::draw_rail(Canvas& canvas) const {
  const Rect rail = page_.rail();
  if (rail.width <= 0) return;
  canvas.set_clip(rail);
  const float scale = page_.scale(), margin = 22 * scale, size = theme::kBody * scale;
  const std::size_t here = chapter_in_view();
  for (std::size_t i = 0; i < page_.chapters().size(); ++i) {
    const Rect row = page_.rail_entry(i);
    const GalleryPage::Chapter& chapter = page_.chapters()[i];
    if (i == here) canvas.fill(row.shrunk(scale), theme::kAccentDark, 4 * scale);
    const float y = row.y + row.height * 0.5f + size * 0.36f;
    const std::string count = fmt::format("{}", chapter.count);
    const Font& font = studio_->sans;
    const float room = row.width - 1.6f * margin - font.width_px(count, size);
    // A long name is cut where its lines would break.
    const std::vector<std::string> lines = wrap(font, chapter.name, size, room);
    canvas.text(font, {margin, y}, lines.empty() ? "" : lines[0] + (lines.size() > 1 ? " ..." : ""),
                size, i == here ? theme::kAccent : theme::kText);
    canvas.text(font, {row.right() - 0.4f * margin, y}, count, size, theme::kDim, Align::kRight);
  }
  canvas.clear_clip();
}

void Gallery::draw_caption(std::size_t place, Canvas& canvas) const {
  const DemoInfo& info = all_demos()[page_.shown()[place]];
  const Rect rect = page_.thumbnail(place), cell = page_.cell(place);
  const Font& font = studio_->sans;
  const float scale = page_.scale();
  canvas.fill(rect, theme::kPanel);
  if (place == place_) {
    const float border = 3 * scale;
    canvas.frame(rect.shrunk(-border - 1), border, theme::kAccent, theme::kRadius * 0.5f * scale);
  }
  const float line = theme::kBody * scale * 1.3f, small = theme::kSmall * scale;
  float y = rect.bottom() + line * 1.1f;
  canvas.text(font, {rect.x, y}, info.name, theme::kBody * 1.1f * scale,
              place == place_ ? theme::kAccent : theme::kText);
  std::vector<std::string> lines = wrap(font, info.summary, small, rect.width);
  const auto most =
      static_cast<std::size_t>(std::max(0.0f, (cell.bottom() + 8 * scale - y) / (line * 0.9f)));
  if (lines.size() > most && most > 0) lines[most - 1] += " ...";
  lines.resize(std::min(lines.size(), most));
  for (const std::string& words : lines) {
    y += line * 0.9f;
    canvas.text(font, {rect.x, y}, words, small, theme::kDim);
  }
}

}  // namespace kinescope
