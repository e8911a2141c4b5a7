#include "demos/vector_view.h"

#include <algorithm>
#include <utility>

#include "demos/console.h"
#include "demos/picture_name.h"
#include "display/light_encode.h"
#include "display/vector/storage_tube.h"
#include "raster/image/codecs.h"
#include "raster/image/draw.h"

namespace kinescope {
namespace {

using MakeShow = std::function<VectorShow(Size, Workers&)>;

/// Time on the tube is its own: it begins anew with each size of the window.
class VectorView : public ClonableDemo<VectorView> {
 public:
  VectorView(const DemoSetup& setup, MakeShow make)
      : ClonableDemo(setup, {}), make_(std::move(make)) {
    resized();
  }
  std::size_t state_bytes() const override { return sizeof(*this); }
  bool still() const override { return still_; }

 private:
  void resized() override {
    show_ = make_({width(), height()}, studio().workers);
    now_ = Seconds(0);
    still_ = false;
  }
  void update(const Step&) override {}
  void draw(const Step& step, Image<Srgb8>& picture) override {
    now_ += step.exposure.length();
    const Image<LinearRgb>& light = show_.expose(now_, studio().workers);
    still_ = show_.still();
    if (still_) return;
    const double part = std::clamp(step.exposure.length().count() * 60, 1.0 / 64, 1.0);
    encode_light(light, ExposureGain::fixed(static_cast<float>(1 / part)), studio().workers,
                 picture);
  }

  MakeShow make_;
  VectorShow show_;  // shared by copies
  Seconds now_{0};
  bool still_ = false;
};

/// What a drawing has more than one that had so many strokes and texts.
VectorDrawing news_of(const VectorDrawing& drawing, std::size_t segments, std::size_t texts) {
  VectorDrawing news;
  news.origin = drawing.origin;
  news.size = drawing.size;
  for_each_run(drawing, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    news.use(pen);
    for (std::size_t i = std::max(first, segments); i < last; ++i) {
      news.segments.push_back(drawing.segments[i]);
    }
  });
  for (std::size_t i = texts; i < drawing.texts.size(); ++i) {
    news.texts.push_back(drawing.texts[i]);
    news.texts.back().segments -= std::min(news.texts.back().segments, segments);
  }
  return news;
}

class TerminalView : public ClonableDemo<TerminalView> {
 public:
  TerminalView(const DemoSetup& setup, std::shared_ptr<VectorTerminal> terminal)
      : ClonableDemo(setup, {}), terminal_(std::move(terminal)) {
    resized();
  }
  std::size_t state_bytes() const override { return sizeof(*this); }
  bool still() const override { return still_; }

 private:
  void resized() override {
    tube_ = std::make_shared<StorageTube>(find_storage_tube("4014"), width(), height());
    now_ = Seconds(0);
    segments_ = texts_ = 0;
  }
  void update(const Step& step) override {
    still_ = step.events.empty();
    for (const InputEvent& event : step.events) answer(event);
    terminal_->poll(0);
    const VectorDrawing& drawing = terminal_->drawing();
    if (drawing.segments.size() < segments_ || drawing.texts.size() < texts_) {
      tube_->erase();
      segments_ = texts_ = 0;
    }
    if (drawing.segments.size() == segments_ && drawing.texts.size() == texts_) return;
    tube_->draw(news_of(drawing, segments_, texts_));
    segments_ = drawing.segments.size();
    texts_ = drawing.texts.size();
  }
  /// Programs ask for a copy; it shows all that they had drawn by then.
  void copy_where_asked() {
    const auto& events = terminal_->drawing().events;
    const auto asked = std::count_if(events.begin(), events.end(), [](const DrawingEvent& e) {
      return e.kind == DrawingEvent::Kind::kHardCopy;
    });
    copy_due_ = copy_due_ || asked > copies_;
    copies_ = asked;
    if (!copy_due_ || tube_->busy_until() > now_) return;
    copy_due_ = false;
    const std::string file = free_picture_name("hard-copy");
    write_png(file, tube_->hard_copy());
    print_remark("wrote " + file, false);
  }
  void draw(const Step& step, Image<Srgb8>& picture) override {
    now_ += step.exposure.length();
    const Image<LinearRgb>& light = tube_->expose(now_, studio().workers);
    copy_where_asked();
    const bool crosshair = terminal_->crosshair_shown();
    still_ = still_ && !tube_->changed() && crosshair == crosshair_;
    crosshair_ = crosshair;
    if (still_) return;
    encode_light(light, ExposureGain::fixed(1), studio().workers, picture);
    if (!crosshair) return;
    constexpr Srgb8 kCrosshair{160, 160, 160};
    draw_line(picture, 0, mouse_y_, width() - 1, mouse_y_, kCrosshair);
    draw_line(picture, mouse_x_, 0, mouse_x_, height() - 1, kCrosshair);
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

  std::shared_ptr<VectorTerminal> terminal_;
  std::shared_ptr<StorageTube> tube_;
  Seconds now_{0};
  std::size_t segments_ = 0, texts_ = 0;  // that the tube was given
  std::ptrdiff_t copies_ = 0;             // that were asked for since the last erasure
  bool copy_due_ = false;
  bool still_ = false, crosshair_ = false;
  int mouse_x_ = 0, mouse_y_ = 0;
};

}  // namespace

DemoInfo vector_view(MakeShow make) {
  DemoInfo info{"vector", "", "Strokes of the user's own", {}};
  info.steps_back = false;
  info.create = [make = std::move(make)](const DemoSetup& setup) {
    return std::make_unique<VectorView>(setup, make);
  };
  return info;
}

DemoInfo vector_view(std::shared_ptr<VectorTerminal> terminal) {
  DemoInfo info{"vector", "", "Strokes of the user's own", {}};
  info.steps_back = false;
  info.create = [terminal](const DemoSetup& setup) {
    return std::make_unique<TerminalView>(setup, terminal);
  };
  return info;
}

}  // namespace kinescope
