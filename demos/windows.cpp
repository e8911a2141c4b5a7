// Windows and menus on a bitmap screen: drawn back to front, dragged by an outline, popped up over
// what was there.
#include <array>
#include <optional>

#include "demos/lesson/lesson.h"
#include "demos/window_pile.h"

namespace kinescope {
namespace {

enum { kOperation };
constexpr std::array kOps = {RasterOp::kXor, RasterOp::kCopy, RasterOp::kOr, RasterOp::kAnd};
constexpr Srgb8 kDesk{44, 84, 104, 255};

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
                         "raster operation of the outline that is dragged")}) {}

 private:
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
      pile_.top().corner = at - *grip_;
      grip_.reset();
      trail_.clear();
      return true;
    }
    return event.kind == InputKind::kMouseMove && pile_.menu_is_open() && moved;
  }

  bool press(MouseButton button) {
    if (const auto row = pile_.menu_row(mouse_)) {
      pile_.choose(*row);
      pile_.close_menu();
      return true;
    }
    pile_.close_menu();
    const auto hit = pile_.at(mouse_);
    if (button == MouseButton::kRight) {
      pile_.open_menu(mouse_, {world().columns(), world().rows()}, hit);
      return true;
    }
    if (!hit) return true;
    pile_.raise(*hit);
    const glm::ivec2 held = mouse_ - pile_.top().corner;
    if (held.y < WindowPile::kTitle) grip_ = held;
    return true;
  }

  Course record() const override {
    Image<Srgb8> screen(world().columns(), world().rows(), kDesk), before;
    Course course;
    course.papers = {screen};
    Track track("screen", {"pixels"});
    const auto end_step = [&](const std::string& what) {
      double changed = 0;
      for (int y = 0; y < screen.height(); ++y) {
        for (int x = 0; x < screen.width(); ++x) {
          if (screen.at(x, y) == before.at(x, y)) continue;
          track.plot(x, y, screen.at(x, y));
          ++changed;
        }
      }
      track.step({changed}, what);
    };
    for (const ScreenWindow& window : pile_.windows()) {
      before = screen;
      draw_window(screen, window);
      end_step(window.name + ", over what lies below it");
    }
    if (grip_) {
      // What came of drawing the outline, drawing it again to take it away, and so on.
      const RasterOp op = kOps[static_cast<std::size_t>(knob(kOperation).index())];
      before = screen;
      for (std::size_t i = 0; i < trail_.size(); ++i) {
        draw_outline(screen, pile_.top(), trail_[i], op);
        if (i + 1 < trail_.size()) draw_outline(screen, pile_.top(), trail_[i], op);
      }
      end_step("the outline, by " + knob(kOperation).text());
    }
    if (pile_.menu_is_open()) {
      before = screen;
      pile_.draw_menu(screen, mouse_);
      end_step("the menu; what it hides was saved");
    }
    course.tracks.push_back(std::move(track));
    return course;
  }

  WindowPile pile_;
  std::optional<glm::ivec2> grip_;  // where the top one is held, from its corner
  std::vector<glm::ivec2> trail_;   // of the outline's corner
  glm::ivec2 mouse_{-1, -1};
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
