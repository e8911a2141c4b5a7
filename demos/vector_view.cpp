#include "demos/vector_view.h"

#include <algorithm>
#include <utility>

#include "display/vector/input/strokes_picture.h"
#include "raster/image/draw.h"

namespace kinescope {
namespace {

class VectorView : public ClonableDemo<VectorView> {
 public:
  VectorView(const DemoSetup& setup, std::shared_ptr<const VectorDrawing> drawing,
             std::shared_ptr<VectorTerminal> terminal)
      : ClonableDemo(setup, {}), drawing_(std::move(drawing)), terminal_(std::move(terminal)) {}

  std::size_t state_bytes() const override { return sizeof(*this) + cached_.pixels().size_bytes(); }

 private:
  void resized() override { stale_ = true; }
  void update(const Step& step) override {
    if (!terminal_) return;
    for (const InputEvent& event : step.events) answer(event);
    stale_ |= terminal_->poll(0);
  }
  void draw(const Step&, Image<Srgb8>& picture) override {
    if (stale_ || cached_.width() != width() || cached_.height() != height()) {
      const VectorDrawing& shown = terminal_ ? terminal_->drawing() : *drawing_;
      cached_ = strokes_picture(shown, width(), height(), studio().workers);
    }
    stale_ = false;
    picture = cached_;
    if (terminal_ && terminal_->crosshair_shown()) {
      constexpr Srgb8 kCrosshair{160, 160, 160};
      draw_line(picture, 0, mouse_y_, width() - 1, mouse_y_, kCrosshair);
      draw_line(picture, mouse_x_, 0, mouse_x_, height() - 1, kCrosshair);
    }
  }

  /// Tells the terminal what the user did with the crosshair.
  void answer(const InputEvent& event) {
    if (event.kind == InputKind::kMouseMove) {
      mouse_x_ = event.x;
      mouse_y_ = event.y;
    }
    const bool typed = event.kind == InputKind::kText && !event.key.empty();
    if (!typed && event.kind != InputKind::kMouseDown) return;
    const glm::vec2 size = terminal_->drawing().size;
    const float scale =
        std::min(static_cast<float>(width()) / size.x, static_cast<float>(height()) / size.y);
    const glm::vec2 from_middle{static_cast<float>(mouse_x_) - 0.5f * static_cast<float>(width()),
                                0.5f * static_cast<float>(height()) - static_cast<float>(mouse_y_)};
    const glm::vec2 at = glm::vec2(0.5f) * size + from_middle / scale;
    terminal_->press(typed ? event.key[0] : ' ', std::clamp(static_cast<int>(at.x), 0, 4095),
                     std::clamp(static_cast<int>(at.y), 0, 3119));
  }

  std::shared_ptr<const VectorDrawing> drawing_;
  std::shared_ptr<VectorTerminal> terminal_;
  Image<Srgb8> cached_;
  bool stale_ = true;
  int mouse_x_ = 0, mouse_y_ = 0;
};

DemoInfo info_of(std::shared_ptr<const VectorDrawing> drawing,
                 std::shared_ptr<VectorTerminal> terminal) {
  DemoInfo info{"vector", "", "Strokes of the user's own", {}};
  info.create = [drawing, terminal](const DemoSetup& setup) {
    return std::make_unique<VectorView>(setup, drawing, terminal);
  };
  return info;
}

}  // namespace

DemoInfo vector_view(VectorDrawing drawing) {
  return info_of(std::make_shared<const VectorDrawing>(std::move(drawing)), nullptr);
}

DemoInfo vector_view(std::shared_ptr<VectorTerminal> terminal) {
  return info_of(nullptr, std::move(terminal));
}

}  // namespace kinescope
