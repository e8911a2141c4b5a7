#include "demos/gallery.h"

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

constexpr float kHeader = 84, kCaption = 74, kCellGap = 28, kMinCell = 250;
// Steps until a thumbnail shows its demo at its best.
constexpr std::int64_t kFirstSteps = 4;

}  // namespace

Gallery::Gallery(std::shared_ptr<Studio> studio, int width, int height, std::uint64_t seed)
    : studio_(std::move(studio)),
      seed_(seed),
      thumbnails_(all_demos().size()),
      width_(width),
      height_(height) {
  lay_out();
}

void Gallery::lay_out() {
  scale_ = theme::scale_for(height_);
  const auto count = static_cast<float>(thumbnails_.size());
  const float room = static_cast<float>(width_) - kCellGap * scale_;
  const float most = std::max(1.0f, std::floor(room / ((kMinCell + kCellGap) * scale_)));
  const float columns = std::min(std::ceil(std::sqrt(count)), most);
  // Pictures of 4:3 that leave room for as many rows as a square page would have.
  // More scroll.
  const float least = (0.75f * kMinCell + kCaption + kCellGap) * scale_;
  const float fitting = std::floor((static_cast<float>(height_) - kHeader * scale_) / least);
  const float rows = std::min({std::ceil(count / columns), columns, std::max(1.0f, fitting)});
  const float by_height = (static_cast<float>(height_) - kHeader * scale_) / rows;
  const float wide = room / columns - kCellGap * scale_;
  const float tall = (by_height - (kCaption + kCellGap) * scale_) * 4 / 3;
  cell_width_ = std::max(16.0f, std::min(wide, tall));
  cell_height_ = cell_width_ * 0.75f + kCaption * scale_;
  columns_ = static_cast<std::size_t>(columns);
  const float shown =
      (static_cast<float>(height_) - kHeader * scale_) / (cell_height_ + kCellGap * scale_);
  rows_shown_ = static_cast<std::size_t>(std::max(1.0f, shown + 0.01f));
  for (Thumbnail& thumbnail : thumbnails_) thumbnail = Thumbnail{};
  select(selected_);
}

void Gallery::select(std::size_t index) {
  selected_ = index;
  const std::size_t row = index / columns_;
  first_row_ = std::clamp(first_row_, row < rows_shown_ ? 0 : row - rows_shown_ + 1, row);
  dirty_ = true;
}

Rect Gallery::cell(std::size_t index) const {
  const float gap = kCellGap * scale_;
  const auto columns = static_cast<float>(columns_);
  const float left = (static_cast<float>(width_) - columns * (cell_width_ + gap) + gap) * 0.5f;
  const auto column = static_cast<float>(index % columns_);
  const float row = static_cast<float>(index / columns_) - static_cast<float>(first_row_);
  return {std::round(left + column * (cell_width_ + gap)),
          std::round(kHeader * scale_ + row * (cell_height_ + gap)), std::floor(cell_width_),
          std::floor(cell_height_)};
}

Rect Gallery::thumbnail_place(std::size_t index) const {
  const Rect place = cell(index);
  return {place.x, place.y, place.width, std::floor(place.width * 0.75f)};
}

std::optional<std::size_t> Gallery::demo_at(int x, int y) const {
  for (std::size_t i = 0; i < thumbnails_.size(); ++i) {
    if (cell(i).contains(static_cast<float>(x), static_cast<float>(y))) return i;
  }
  return std::nullopt;
}

void Gallery::key(const std::string& key) {
  const std::size_t last = thumbnails_.size() - 1;
  if (key == "Left" && selected_ > 0) select(selected_ - 1);
  if (key == "Right" && selected_ < last) select(selected_ + 1);
  if (key == "Up" && selected_ >= columns_) select(selected_ - columns_);
  if (key == "Down" && selected_ + columns_ <= last) select(selected_ + columns_);
  if (key == "Home") select(0);
  if (key == "End") select(last);
  if (key == "Return" || key == "Space") chosen_ = selected_;
}

void Gallery::handle(const InputEvent& event) {
  switch (event.kind) {
    case InputKind::kKeyDown:
      key(event.key);
      break;
    case InputKind::kMouseMove:
      if (const auto hit = demo_at(event.x, event.y); hit && *hit != selected_) select(*hit);
      break;
    case InputKind::kMouseDown:
      chosen_ = demo_at(event.x, event.y);
      break;
    case InputKind::kWheel:
      key(event.wheel > 0 ? "Up" : "Down");
      break;
    case InputKind::kResize:
      width_ = usable_size(event).x;
      height_ = usable_size(event).y;
      lay_out();
      break;
    default:
      break;
  }
}

std::optional<std::size_t> Gallery::take_choice() {
  dirty_ = true;
  if (chosen_) select(*chosen_);
  return std::exchange(chosen_, std::nullopt);
}

bool Gallery::step_thumbnail(std::size_t index) {
  const Rect place = thumbnail_place(index);
  if (place.bottom() <= 0 || place.y >= static_cast<float>(height_)) return false;
  Thumbnail& thumbnail = thumbnails_[index];
  if (!thumbnail.demo) {
    thumbnail.demo = all_demos()[index].create(
        {studio_, static_cast<int>(place.width), static_cast<int>(place.height), seed_});
  }
  const Seconds end = thumbnail.now + thumbnail.demo->refresh().period();
  thumbnail.demo->step({{thumbnail.now, end}, {}}, thumbnail.picture);
  thumbnail.now = end;
  ++thumbnail.steps;
  return true;
}

void Gallery::show_thumbnail(std::size_t index) {
  const Image<Srgb8>& picture = thumbnails_[index].picture;
  const Rect place = thumbnail_place(index);
  const int left = static_cast<int>(place.x), top = static_cast<int>(place.y);
  const int width = std::min(picture.width(), width_ - left);
  for (int y = std::max(0, -top); y < std::min(picture.height(), height_ - top); ++y) {
    std::copy_n(picture.row(y), std::max(0, width), frame_.row(top + y) + left);
  }
}

bool Gallery::tick(int) {
  const bool redraw = std::exchange(dirty_, false);
  if (redraw) draw_page();
  step_thumbnail(selected_);
  show_thumbnail(selected_);
  // The others come one a tick, so that the first page is there at once.
  for (std::size_t i = 0; i < thumbnails_.size(); ++i) {
    if (i != selected_ && thumbnails_[i].steps < kFirstSteps && step_thumbnail(i)) {
      show_thumbnail(i);
      break;
    }
  }
  return true;
}

void Gallery::draw_page() {
  frame_ = Image<Srgb8>(width_, height_, theme::kBackground);
  Canvas canvas(frame_);
  const float margin = cell(0).x;
  const float baseline = kHeader * scale_ * 0.58f;
  canvas.text(studio_->sans, {margin, baseline}, "Kinescope", theme::kTitle * 1.25f * scale_,
              theme::kText);
  canvas.text(studio_->sans, {static_cast<float>(width_) - margin, baseline},
              "arrows choose   Enter starts   Esc leaves", theme::kSmall * scale_, theme::kDim,
              Align::kRight);
  for (std::size_t i = 0; i < thumbnails_.size(); ++i) {
    draw_caption(i, canvas);
    if (!thumbnails_[i].picture.empty()) show_thumbnail(i);
  }
}

void Gallery::draw_caption(std::size_t index, Canvas& canvas) {
  const DemoInfo& info = all_demos()[index];
  const Rect place = thumbnail_place(index);
  const Font& font = studio_->sans;
  canvas.fill(place, theme::kPanel);
  if (index == selected_) {
    const float border = 3 * scale_;
    canvas.frame(place.shrunk(-border - 1), border, theme::kAccent, theme::kRadius * 0.5f * scale_);
  }
  const float line = theme::kBody * scale_ * 1.45f;
  float y = place.bottom() + line * 1.15f;
  canvas.text(font, {place.x, y}, info.name, theme::kBody * 1.1f * scale_,
              index == selected_ ? theme::kAccent : theme::kText);
  const float small = theme::kSmall * scale_;
  const float room = place.width - font.width_px(info.name, theme::kBody * 1.1f * scale_) - small;
  for (const std::string_view chapter :
       {info.chapter, info.chapter.substr(0, info.chapter.find(' '))}) {
    if (font.width_px(chapter, small) > room) continue;
    canvas.text(font, {place.right(), y}, chapter, small, theme::kDim, Align::kRight);
    break;
  }
  std::vector<std::string> lines = wrap(font, info.summary, small, place.width);
  const auto most = static_cast<std::size_t>(
      std::max(0.0f, (cell(index).bottom() + 0.5f * kCellGap * scale_ - y) / (line * 0.9f)));
  if (lines.size() > most && most > 0) lines[most - 1] += " ...";
  lines.resize(std::min(lines.size(), most));
  for (const std::string& words : lines) {
    y += line * 0.9f;
    canvas.text(font, {place.x, y}, words, small, theme::kDim);
  }
}

}  // namespace kinescope
