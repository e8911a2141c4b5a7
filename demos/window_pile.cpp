#include "demos/window_pile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "raster/characters/bitmap_font.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {
namespace {

constexpr int kRow = 14, kMenuWidth = 76;
constexpr std::array kMenuWords = {"raise", "lower", "new window", "close"};
constexpr Srgb8 kPaper{228, 226, 216, 255}, kInk{24, 24, 30, 255};
constexpr std::array kTitles = {Srgb8{224, 150, 40, 255}, Srgb8{90, 170, 110, 255},
                                Srgb8{190, 90, 90, 255}, Srgb8{110, 120, 210, 255}};

bool holds(const PixelRect& area, glm::ivec2 p) {
  return p.x >= area.x0 && p.x < area.x1 && p.y >= area.y0 && p.y < area.y1;
}

void write(Image<Srgb8>& screen, glm::ivec2 pen, const std::string& words, const PixelRect& clip,
           Srgb8 colour) {
  BitmapFont::fixed().draw(words, pen, [&](int x, int y) {
    if (holds(clip, {x, y}) && screen.contains(x, y)) screen.at(x, y) = colour;
  });
}

/// A few lines of text.
void draw_note(Image<Srgb8>& screen, const PixelRect& inner) {
  int y = inner.y0 + 14;
  for (const char* line : {"Windows lie on", "each other like", "sheets of paper:", "those above",
                           "are drawn last."}) {
    write(screen, {inner.x0 + 6, y}, line, inner, kInk);
    y += kRow;
  }
}

/// A fan of lines; of a clock, their ends.
void draw_fan(Image<Srgb8>& screen, const PixelRect& inner, std::size_t look) {
  const glm::ivec2 middle(inner.x0 + (inner.x1 - inner.x0) / 2,
                          inner.y0 + (inner.y1 - inner.y0) / 2);
  const int reach = std::min(inner.x1 - inner.x0, inner.y1 - inner.y0) / 2 - 6;
  for (int i = 0; i < 12; ++i) {
    const double turn = i * 0.5235987755982988;
    const glm::ivec2 tip =
        middle + glm::ivec2(glm::round(double(reach) * glm::dvec2(std::sin(turn), std::cos(turn))));
    const bool whole = look == 1;
    for (BresenhamSteps line(whole ? middle : middle + (tip - middle) * 4 / 5, tip); line.next();) {
      if (screen.contains(line.at().x, line.at().y)) {
        screen.at(line.at().x, line.at().y) = kTitles[look];
      }
    }
  }
}

}  // namespace

WindowPile::WindowPile()
    : windows_{{"editor", {24, 24}, {150, 100}, 0},
               {"drawing", {120, 70}, {130, 110}, 1},
               {"clock", {210, 30}, {84, 90}, 2}} {}

std::optional<std::size_t> WindowPile::at(glm::ivec2 p) const {
  for (std::size_t i = windows_.size(); i-- > 0;) {
    if (holds(windows_[i].area(), p)) return i;
  }
  return std::nullopt;
}

void WindowPile::raise(std::size_t window) {
  const auto at = windows_.begin() + static_cast<std::ptrdiff_t>(window);
  std::rotate(at, at + 1, windows_.end());
}

PixelRect WindowPile::menu_area() const {
  const int height = kRow * static_cast<int>(kMenuWords.size()) + 4;
  return {menu_->x, menu_->y, menu_->x + kMenuWidth, menu_->y + height};
}

void WindowPile::open_menu(glm::ivec2 at, glm::ivec2 screen, std::optional<std::size_t> hit) {
  menu_ = at;
  const PixelRect area = menu_area();
  *menu_ -= glm::max(glm::ivec2(area.x1, area.y1) - screen, glm::ivec2(0));
  aimed_at_ = hit;
}

std::optional<std::size_t> WindowPile::menu_row(glm::ivec2 p) const {
  if (!menu_ || !holds(menu_area(), p)) return std::nullopt;
  const auto row = static_cast<std::size_t>((p.y - menu_->y - 2) / kRow);
  return std::min(row, kMenuWords.size() - 1);
}

void WindowPile::choose(std::size_t row) {
  constexpr std::size_t kNew = 2;
  if (row == kNew) {
    if (windows_.size() == kMostWindows) return;
    ++opened_;
    windows_.push_back({fmt::format("window {}", opened_), *menu_, {110, 80}, opened_ % 4});
    return;
  }
  if (!aimed_at_ || *aimed_at_ >= windows_.size()) return;
  const auto window = windows_.begin() + static_cast<std::ptrdiff_t>(*aimed_at_);
  if (row == 0) raise(*aimed_at_);
  if (row == 1) std::rotate(windows_.begin(), window, window + 1);
  if (row == 3) windows_.erase(window);
}

void WindowPile::draw_menu(Image<Srgb8>& screen, glm::ivec2 mouse) const {
  const PixelRect area = menu_area();
  raster_fill(screen, area, kInk, RasterOp::kCopy);
  const PixelRect inner{area.x0 + 1, area.y0 + 1, area.x1 - 1, area.y1 - 1};
  raster_fill(screen, inner, kPaper, RasterOp::kCopy);
  for (std::size_t i = 0; i < kMenuWords.size(); ++i) {
    const int top = area.y0 + 2 + kRow * static_cast<int>(i);
    write(screen, {area.x0 + 6, top + 11}, kMenuWords[i], inner, kInk);
    if (menu_row(mouse) == i) {
      raster_fill(screen, {inner.x0, top, inner.x1, top + kRow}, {}, RasterOp::kInvert);
    }
  }
}

void draw_window(Image<Srgb8>& screen, const ScreenWindow& w) {
  const PixelRect area = w.area();
  raster_fill(screen, area, kInk, RasterOp::kCopy);
  raster_fill(screen, {area.x0 + 1, area.y0 + 1, area.x1 - 1, area.y0 + WindowPile::kTitle},
              kTitles[w.look], RasterOp::kCopy);
  const PixelRect inner{area.x0 + 1, area.y0 + WindowPile::kTitle + 1, area.x1 - 1, area.y1 - 1};
  raster_fill(screen, inner, kPaper, RasterOp::kCopy);
  write(screen, w.corner + glm::ivec2(6, 12), w.name, area, kInk);
  w.look == 0 ? draw_note(screen, inner) : draw_fan(screen, inner, w.look);
}

void draw_outline(Image<Srgb8>& screen, const ScreenWindow& window, glm::ivec2 corner,
                  RasterOp op) {
  const glm::ivec2 far = corner + window.size;
  constexpr Srgb8 kPen{200, 200, 200, 255};
  raster_fill(screen, {corner.x, corner.y, far.x, corner.y + 2}, kPen, op);
  raster_fill(screen, {corner.x, far.y - 2, far.x, far.y}, kPen, op);
  raster_fill(screen, {corner.x, corner.y + 2, corner.x + 2, far.y - 2}, kPen, op);
  raster_fill(screen, {far.x - 2, corner.y + 2, far.x, far.y - 2}, kPen, op);
}

}  // namespace kinescope
