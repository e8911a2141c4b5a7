#include "demos/gallery_page.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

#include "demos/ui/theme.h"

namespace kinescope {
namespace {

constexpr float kHeader = 76, kCaption = 78, kGap = 22, kMinCell = 236, kHeading = 46;
constexpr float kRail = 340, kLeastForRail = 1100, kRailRow = 30;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

int number_of(std::string_view chapter) {
  int number = 1000;
  std::from_chars(chapter.data(), chapter.data() + chapter.size(), number);
  return number;
}

}  // namespace

bool found_by(const DemoInfo& info, std::string_view words) {
  std::string all;
  for (const std::string_view part : {info.name, info.chapter, info.summary}) {
    all.append(part).append("\n");
  }
  for (const std::string_view topic : info.topics) all.append(topic).append("\n");
  all = lower(all);
  const std::string wanted = lower(words);
  for (std::size_t begin = 0; begin < wanted.size();) {
    const std::size_t end = std::min(wanted.find(' ', begin), wanted.size());
    if (all.find(wanted.substr(begin, end - begin)) == std::string::npos) return false;
    begin = end + 1;
  }
  return true;
}

std::vector<std::size_t> in_order_of_chapters(std::span<const DemoInfo> demos) {
  std::vector<std::size_t> order(demos.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const int left = number_of(demos[a].chapter), right = number_of(demos[b].chapter);
    return left != right ? left < right : demos[a].chapter < demos[b].chapter;
  });
  return order;
}

GalleryPage::GalleryPage(std::span<const DemoInfo> demos, int width, int height)
    : demos_(demos), order_(in_order_of_chapters(demos)), width_(width), height_(height) {
  find("");
}

void GalleryPage::find(std::string_view words) {
  shown_.clear();
  for (const std::size_t demo : order_) {
    if (found_by(demos_[demo], words)) shown_.push_back(demo);
  }
  scroll_ = 0;
  lay_out();
}

void GalleryPage::resize(int width, int height) {
  width_ = width;
  height_ = height;
  lay_out();
}

void GalleryPage::lay_out() {
  scale_ = theme::scale_for(height_);
  const float gap = kGap * scale_, across = room().width - 2 * gap;
  const float most = std::floor((across + gap) / (kMinCell * scale_ + gap));
  columns_ = static_cast<std::size_t>(std::max(1.0f, most));
  const auto columns = static_cast<float>(columns_);
  // Not higher than the window shows.
  const float tallest = (room().height - (kHeading + kCaption) * scale_) * 4 / 3;
  cell_width_ = (across + gap) / columns - gap;
  cell_width_ = std::floor(std::max(16.0f, std::min(cell_width_, tallest)));
  left_ = room().x + gap;
  chapters_.clear();
  float y = 0;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const std::string_view name = demos_[shown_[i]].chapter;
    if (chapters_.empty() || chapters_.back().name != name) {
      if (!chapters_.empty()) {
        y += std::ceil(static_cast<float>(chapters_.back().count) / columns) * row_height();
      }
      chapters_.push_back({name, i, 0, y});
      y += kHeading * scale_;
    }
    ++chapters_.back().count;
  }
  if (!chapters_.empty()) {
    y += std::ceil(static_cast<float>(chapters_.back().count) / columns) * row_height();
  }
  length_ = y;
  scroll_by(0);
}

float GalleryPage::row_height() const {
  return std::floor(cell_width_ * 0.75f + (kCaption + kGap) * scale_);
}

std::size_t GalleryPage::chapter_of(std::size_t place) const {
  std::size_t chapter = 0;
  while (chapter + 1 < chapters_.size() && chapters_[chapter + 1].first <= place) ++chapter;
  return chapter;
}

Rect GalleryPage::header() const {
  return {0, 0, static_cast<float>(width_), std::floor(kHeader * scale_)};
}

Rect GalleryPage::rail() const {
  const bool has = static_cast<float>(width_) >= kLeastForRail * scale_;
  const float top = header().height;
  return {0, top, has ? std::floor(kRail * scale_) : 0, static_cast<float>(height_) - top};
}

Rect GalleryPage::room() const {
  const Rect side = rail();
  return {side.right(), side.y, static_cast<float>(width_) - side.right(), side.height};
}

Rect GalleryPage::rail_entry(std::size_t chapter) const {
  const Rect side = rail();
  const float row = kRailRow * scale_;
  return {side.x, side.y + row * static_cast<float>(chapter), side.width, row};
}

Rect GalleryPage::heading(std::size_t chapter) const {
  const float y = room().y + chapters_[chapter].top - scroll_;
  return {left_, std::floor(y), room().right() - left_ - kGap * scale_, kHeading * scale_};
}

Rect GalleryPage::on_page(std::size_t place) const {
  const Chapter& chapter = chapters_[chapter_of(place)];
  const std::size_t within = place - chapter.first;
  const auto column = static_cast<float>(within % columns_);
  const auto row = static_cast<float>(within / columns_);
  return {left_ + column * (cell_width_ + kGap * scale_),
          chapter.top + kHeading * scale_ + row * row_height(), cell_width_,
          row_height() - kGap * scale_};
}

Rect GalleryPage::cell(std::size_t place) const {
  Rect rect = on_page(place);
  rect.x = std::floor(rect.x);
  rect.y = std::floor(rect.y + room().y - scroll_);
  return rect;
}

Rect GalleryPage::thumbnail(std::size_t place) const {
  const Rect all = cell(place);
  return {all.x, all.y, all.width, std::floor(all.width * 0.75f)};
}

std::optional<std::size_t> GalleryPage::place_at(int x, int y) const {
  const auto px = static_cast<float>(x), py = static_cast<float>(y);
  if (!room().contains(px, py)) return std::nullopt;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (cell(i).contains(px, py)) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> GalleryPage::chapter_at(int x, int y) const {
  for (std::size_t i = 0; i < chapters_.size(); ++i) {
    if (rail_entry(i).contains(static_cast<float>(x), static_cast<float>(y))) return i;
  }
  return std::nullopt;
}

float GalleryPage::farthest() const { return std::max(0.0f, length_ - room().height); }

void GalleryPage::scroll_by(float pixels) {
  scroll_ = std::round(std::clamp(scroll_ + pixels, 0.0f, farthest()));
}

void GalleryPage::scroll_to_chapter(std::size_t chapter) {
  scroll_by(chapters_[chapter].top - scroll_);
}

void GalleryPage::reveal(std::size_t place) {
  const Rect rect = on_page(place);
  const bool first_row = place - chapters_[chapter_of(place)].first < columns_;
  const float top = rect.y - (first_row ? kHeading : kGap) * scale_;
  const float bottom = rect.bottom() + 0.5f * kGap * scale_;
  if (bottom > scroll_ + room().height) scroll_by(bottom - scroll_ - room().height);
  if (top < scroll_) scroll_by(top - scroll_);
}

std::size_t GalleryPage::beside(std::size_t place, int rows) const {
  const float middle = on_page(place).x;
  for (int direction = rows < 0 ? -1 : 1; rows != 0; rows -= direction) {
    const float from = on_page(place).y;
    std::optional<std::size_t> best;
    for (std::size_t i = place; i < shown_.size(); i += static_cast<std::size_t>(direction)) {
      const Rect rect = on_page(i);
      if (rect.y == from) continue;
      if (best && rect.y != on_page(*best).y) break;
      if (!best || std::abs(rect.x - middle) < std::abs(on_page(*best).x - middle)) best = i;
    }
    if (!best) return place;
    place = *best;
  }
  return place;
}

int GalleryPage::rows_in_view() const {
  return std::max(1, static_cast<int>(room().height / row_height()));
}

}  // namespace kinescope
