// Windows and menus on a bitmap screen: drawn back to front, dragged by an outline, popped up over
// what was there.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "demos/lesson/lesson.h"
#include "raster/characters/bitmap_font.h"
#include "raster/image/raster_op.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {
namespace {

enum { kOperation };
constexpr std::array kOps = {RasterOp::kXor, RasterOp::kCopy, RasterOp::kOr, RasterOp::kAnd};
constexpr int kTitle = 15, kRow = 14, kMenuWidth = 76;
constexpr std::array kMenuWords = {"raise", "lower", "new window", "close"};
constexpr Srgb8 kDesk{44, 84, 104, 255}, kPaper{228, 226, 216, 255}, kInk{24, 24, 30, 255};
constexpr std::array kTitles = {Srgb8{224, 150, 40, 255}, Srgb8{90, 170, 110, 255},
                                Srgb8{190, 90, 90, 255}, Srgb8{110, 120, 210, 255}};

struct ScreenWindow {
  std::string name;
  glm::ivec2 corner, size;
  std::size_t look;
  PixelRect area() const { return {corner.x, corner.y, corner.x + size.x, corner.y + size.y}; }
};

bool holds(const PixelRect& area, glm::ivec2 p) {
  return p.x >= area.x0 && p.x < area.x1 && p.y >= area.y0 && p.y < area.y1;
}

class Windows : public ClonableDemo<Windows, Lesson> {
 public:
  explicit Windows(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Drag a title: its outline is drawn by exclusive or, and drawn again to "
                         "take it away. A click raises a window, the right button pops up a menu. "
                         "o: other operations leave their traces; Home and n show the drawing.",
             .resolution = 7,
             .speed = 8},
            {choice_knob("outline", {"o"}, {"xor", "copy", "or", "and"}, 0,
                         "raster operation of the outline that is dragged")}) {
    windows_ = {{"editor", {24, 24}, {150, 100}, 0},
                {"drawing", {120, 70}, {130, 110}, 1},
                {"clock", {210, 30}, {84, 90}, 2}};
  }

 private:
  /// The top window there, as its place in the list.
  std::optional<std::size_t> window_at(glm::ivec2 p) const {
    for (std::size_t i = windows_.size(); i-- > 0;) {
      if (holds(windows_[i].area(), p)) return i;
    }
    return std::nullopt;
  }
  PixelRect menu_area() const {
    const int height = kRow * static_cast<int>(kMenuWords.size()) + 4;
    return {menu_->x, menu_->y, menu_->x + kMenuWidth, menu_->y + height};
  }
  std::optional<std::size_t> menu_row(glm::ivec2 p) const {
    if (!menu_ || !holds(menu_area(), p)) return std::nullopt;
    const auto row = static_cast<std::size_t>((p.y - menu_->y - 2) / kRow);
    return std::min(row, kMenuWords.size() - 1);
  }
  void raise(std::size_t i) {
    std::rotate(windows_.begin() + static_cast<std::ptrdiff_t>(i),
                windows_.begin() + static_cast<std::ptrdiff_t>(i) + 1, windows_.end());
  }

  bool answer(const InputEvent& event, LessonScreen::Spot spot) override {
    const glm::ivec2 at(glm::clamp(glm::floor(spot.at), glm::dvec2(-4000), glm::dvec2(4000)));
    const bool moved = mouse_ != at;
    mouse_ = at;
    if (event.kind == InputKind::kMouseDown) return press(event.button);
    if (event.kind == InputKind::kMouseMove && grip_) {
      trail_.push_back(at - *grip_);
      return true;
    }
    if (event.kind == InputKind::kMouseUp && grip_) {
      windows_.back().corner = at - *grip_;
      grip_.reset();
      trail_.clear();
      return true;
    }
    return event.kind == InputKind::kMouseMove && menu_ && moved;
  }

  bool press(MouseButton button) {
    if (const auto row = menu_row(mouse_)) {
      choose(*row);
      menu_.reset();
      return true;
    }
    menu_.reset();
    const auto hit = window_at(mouse_);
    if (button == MouseButton::kRight) {
      menu_ = mouse_;
      // All of it on the screen.
      const PixelRect area = menu_area();
      *menu_ -=
          glm::max(glm::ivec2(area.x1, area.y1) - glm::ivec2(world().columns(), world().rows()),
                   glm::ivec2(0));
      aimed_at_ = hit;
      return true;
    }
    if (!hit) return true;
    raise(*hit);
    const ScreenWindow& top = windows_.back();
    if (mouse_.y < top.corner.y + kTitle) grip_ = mouse_ - top.corner;
    return true;
  }

  void choose(std::size_t row) {
    constexpr std::size_t kNew = 2, kMostWindows = 12;
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

  static void write(Image<Srgb8>& screen, glm::ivec2 pen, const std::string& words,
                    const PixelRect& clip, Srgb8 colour) {
    BitmapFont::fixed().draw(words, pen, [&](int x, int y) {
      if (holds(clip, {x, y}) && screen.contains(x, y)) screen.at(x, y) = colour;
    });
  }

  void draw_window(Image<Srgb8>& screen, const ScreenWindow& w) const {
    const PixelRect area = w.area();
    raster_fill(screen, area, kInk, RasterOp::kCopy);
    raster_fill(screen, {area.x0 + 1, area.y0 + 1, area.x1 - 1, area.y0 + kTitle}, kTitles[w.look],
                RasterOp::kCopy);
    const PixelRect inner{area.x0 + 1, area.y0 + kTitle + 1, area.x1 - 1, area.y1 - 1};
    raster_fill(screen, inner, kPaper, RasterOp::kCopy);
    write(screen, w.corner + glm::ivec2(6, 12), w.name, area, kInk);
    const glm::ivec2 middle(inner.x0 + (inner.x1 - inner.x0) / 2,
                            inner.y0 + (inner.y1 - inner.y0) / 2);
    if (w.look == 0) {
      int y = inner.y0 + 14;
      for (const char* line : {"Windows lie on", "each other like",
                               "sheets of paper:", "those above", "are drawn last."}) {
        write(screen, {inner.x0 + 6, y}, line, inner, kInk);
        y += kRow;
      }
      return;
    }
    // A fan of lines.
    const int reach = std::min(inner.x1 - inner.x0, inner.y1 - inner.y0) / 2 - 6;
    for (int i = 0; i < 12; ++i) {
      const double turn = i * 0.5235987755982988;
      const glm::ivec2 tip =
          middle +
          glm::ivec2(glm::round(double(reach) * glm::dvec2(std::sin(turn), std::cos(turn))));
      const bool whole = w.look == 1;
      for (BresenhamSteps line(whole ? middle : middle + (tip - middle) * 4 / 5, tip);
           line.next();) {
        if (screen.contains(line.at().x, line.at().y)) {
          screen.at(line.at().x, line.at().y) = kTitles[w.look];
        }
      }
    }
  }

  void draw_menu(Image<Srgb8>& screen) const {
    const PixelRect area = menu_area();
    raster_fill(screen, area, kInk, RasterOp::kCopy);
    const PixelRect inner{area.x0 + 1, area.y0 + 1, area.x1 - 1, area.y1 - 1};
    raster_fill(screen, inner, kPaper, RasterOp::kCopy);
    for (std::size_t i = 0; i < kMenuWords.size(); ++i) {
      const int top = area.y0 + 2 + kRow * static_cast<int>(i);
      write(screen, {area.x0 + 6, top + 11}, kMenuWords[i], inner, kInk);
      if (menu_row(mouse_) == i) {
        raster_fill(screen, {inner.x0, top, inner.x1, top + kRow}, {}, RasterOp::kInvert);
      }
    }
  }

  void outline(Image<Srgb8>& screen, glm::ivec2 corner) const {
    const RasterOp op = kOps[static_cast<std::size_t>(knob(kOperation).index())];
    const glm::ivec2 far = corner + windows_.back().size;
    constexpr Srgb8 kPen{200, 200, 200, 255};
    raster_fill(screen, {corner.x, corner.y, far.x, corner.y + 2}, kPen, op);
    raster_fill(screen, {corner.x, far.y - 2, far.x, far.y}, kPen, op);
    raster_fill(screen, {corner.x, corner.y + 2, corner.x + 2, far.y - 2}, kPen, op);
    raster_fill(screen, {far.x - 2, corner.y + 2, far.x, far.y - 2}, kPen, op);
  }

  Course record() const override {
    Image<Srgb8> screen(world().columns(), world().rows(), kDesk), before;
    Course course;
    course.papers = {screen};
    Track track("screen", {"layer", "pixels"});
    double layer = 0;
    const auto end_step = [&](const std::string& what) {
      double changed = 0;
      for (int y = 0; y < screen.height(); ++y) {
        for (int x = 0; x < screen.width(); ++x) {
          if (screen.at(x, y) == before.at(x, y)) continue;
          track.plot(x, y, screen.at(x, y));
          ++changed;
        }
      }
      track.step({++layer, changed}, what);
    };
    for (const ScreenWindow& window : windows_) {
      before = screen;
      draw_window(screen, window);
      end_step(window.name + ", over what lies below it");
    }
    if (grip_) {
      // What came of drawing the outline, drawing it again to take it away, and so on.
      before = screen;
      for (std::size_t i = 0; i < trail_.size(); ++i) {
        outline(screen, trail_[i]);
        if (i + 1 < trail_.size()) outline(screen, trail_[i]);
      }
      end_step("the outline, by " + knob(kOperation).text());
    }
    if (menu_) {
      before = screen;
      draw_menu(screen);
      end_step("the menu; what it hides was saved");
    }
    course.tracks.push_back(std::move(track));
    return course;
  }

  std::vector<ScreenWindow> windows_;  // the top one last
  std::optional<glm::ivec2> grip_;     // where the top one is held, from its corner
  std::vector<glm::ivec2> trail_;      // of the outline's corner
  std::optional<glm::ivec2> menu_;     // its corner
  std::optional<std::size_t> aimed_at_;
  glm::ivec2 mouse_{-1, -1};
  std::size_t opened_ = 0;
};

}  // namespace

DemoInfo windows_demo() {
  return {"windows",
          "1 Displays and coordinates",
          "Windows and menus on a bitmap screen, moved by raster operations",
          [](const DemoSetup& setup) { return std::make_unique<Windows>(setup); },
          1,
          "drag a title, right: a menu",
          {"applications: windows and menus", "raster operations"}};
}

}  // namespace kinescope
