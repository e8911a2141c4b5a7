#include "demos/vector_view.h"

#include <algorithm>
#include <utility>

#include "demos/console.h"
#include "demos/picture_name.h"
#include "display/light_encode.h"
#include "display/vector/storage_tube.h"
#include "raster/base/error.h"
#include "raster/image/codecs.h"
#include "raster/image/draw.h"

namespace kinescope {
namespace {

using MakeShow = std::function<VectorShow(Size, Workers&)>;

bool is_press(const InputEvent& event, std::string_view key) {
  return event.kind == InputKind::kKeyDown && !event.repeated && event.key == key;
}

/// Tells the user where it lies.
void save_copy(const Image<Srgb8>& copy) {
  try {
    const std::string file = free_picture_name("hard-copy");
    write_png(file, copy);
    print_remark("wrote " + file, false);
  } catch (const Error& error) {
    print_remark(error.what(), false);  // the window goes on
  }
}

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
  void update(const Step& step) override {
    for (const InputEvent& event : step.events) {
      const bool copies = is_press(event, "h") && show_.hard_copy;
      if (copies) save_copy(show_.hard_copy());
    }
  }
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

/// A Tektronix screen stores what it is sent; what a plotter draws is shown as files of its kind
/// are.
class TerminalView : public ClonableDemo<TerminalView> {
 public:
  TerminalView(const DemoSetup& setup, std::shared_ptr<VectorTerminal> terminal)
      : ClonableDemo(setup, {}), terminal_(std::move(terminal)) {
    resized();
  }
  std::size_t state_bytes() const override { return sizeof(*this); }
  bool still() const override { return still_; }
  bool typing() const override { return terminal_->crosshair_shown(); }

 private:
  void resized() override { show_anew(); }
  void update(const Step& step) override {
    still_ = step.events.empty();
    for (const InputEvent& event : step.events) answer(event);
    const bool stored = terminal_->stores();
    const bool news = terminal_->poll(0, copier());
    if (!news) return;
    if (stored && terminal_->stores()) return tube_->draw(terminal_->news());
    show_anew();
  }
  /// All that the terminal holds, from its beginning.
  void show_anew() {
    still_ = false;
    shown_until_ = Seconds(0);
    list_ = {};
    tube_.reset();
    if (!terminal_->stores()) {
      list_ = refreshed_show(terminal_->drawing(), {width(), height()});
      return;
    }
    tube_ = std::make_shared<StorageTube>(find_storage_tube("4014"), width(), height());
    tube_->draw(terminal_->drawing());
  }
  VectorTerminal::Copier copier() const {
    return [this](const VectorDrawing& page) {
      copy_to_paper(page, {width(), height()}, studio().workers);
    };
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    shown_until_ += step.exposure.length();
    if (!tube_) {
      const double part = std::clamp(step.exposure.length().count() * 60, 1.0 / 64, 1.0);
      encode_light(list_.expose(shown_until_, studio().workers),
                   ExposureGain::fixed(static_cast<float>(1 / part)), studio().workers, picture);
      still_ = false;
      return;
    }
    draw_tube(picture);
  }
  void draw_tube(Image<Srgb8>& picture) {
    const Image<LinearRgb>& light = tube_->expose(shown_until_, studio().workers);
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

  /// Keys belong to the crosshair while there is one: Escape too is a character then.
  void answer(const InputEvent& event) {
    if (event.kind == InputKind::kMouseMove) {
      mouse_x_ = event.x;
      mouse_y_ = event.y;
    }
    if (terminal_->crosshair_shown()) {
      if (const char key = character(event); key != 0) press(key);
    } else if (is_press(event, "p")) {
      page();
    } else if (is_press(event, "h") && tube_) {
      copier()(terminal_->drawing());
    }
  }
  /// That a key or a click sends; 0: none.
  static char character(const InputEvent& event) {
    if (event.kind == InputKind::kMouseDown) return ' ';
    if (event.kind == InputKind::kText && !event.key.empty()) return event.key[0];
    if (event.kind != InputKind::kKeyDown) return 0;
    return event.key == "Escape" ? '\x1b' : event.key == "Return" ? '\r' : 0;
  }
  void press(char key) {
    const glm::vec2 size = terminal_->drawing().size;
    const float scale =
        std::min(static_cast<float>(width()) / size.x, static_cast<float>(height()) / size.y);
    const glm::vec2 from_middle{static_cast<float>(mouse_x_) - 0.5f * static_cast<float>(width()),
                                0.5f * static_cast<float>(height()) - static_cast<float>(mouse_y_)};
    const glm::vec2 at = glm::vec2(0.5f) * size + from_middle / scale;
    terminal_->press(key, std::clamp(static_cast<int>(at.x), 0, 4095),
                     std::clamp(static_cast<int>(at.y), 0, 3119));
  }
  void page() {
    terminal_->page();
    if (tube_) return tube_->draw(terminal_->news());
    show_anew();
  }

  std::shared_ptr<VectorTerminal> terminal_;
  std::shared_ptr<StorageTube> tube_;  // none: what is drawn is a list
  VectorShow list_;
  Seconds shown_until_{0};  // of the tube or the list
  bool still_ = false, crosshair_ = false;
  int mouse_x_ = 0, mouse_y_ = 0;
};

}  // namespace

void copy_to_paper(const VectorDrawing& page, Size size, Workers& workers) {
  const VectorShow show = storage_show(page, size);
  show.expose(show.settled, workers);
  save_copy(show.hard_copy());
}

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
  info.mouse = "a click, or any key, sends the crosshair's place; without one p is PAGE, h COPY";
  info.create = [terminal](const DemoSetup& setup) {
    return std::make_unique<TerminalView>(setup, terminal);
  };
  return info;
}

}  // namespace kinescope
