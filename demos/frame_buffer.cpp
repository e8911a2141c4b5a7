// Few bits a pixel and a table of colours: animation that moves no pixel, split tables, page flips.
#include <array>
#include <cmath>

#include "demos/demo.h"
#include "demos/monitor.h"
#include "demos/paintings.h"
#include "demos/ui/theme.h"
#include "display/video_mode.h"

namespace kinescope {
namespace {

enum { kPicture, kBits, kTable, kSpeed, kSplit, kFlip };
enum { kPlasma, kRings, kBall };

// A program that draws as fast as it can: not in step with the tube's 59.94 frames a second.
constexpr double kPicturesPerSecond = 47;
constexpr std::array kFormats = {PixelFormat::kIndexed8, PixelFormat::kIndexed4,
                                 PixelFormat::kIndexed2, PixelFormat::kIndexed1};

class FrameBufferDemo : public ClonableDemo<FrameBufferDemo> {
 public:
  explicit FrameBufferDemo(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("picture", {"1", "2", "3"}, {"plasma", "rings", "ball"}, 0,
                         "two that never change a pixel, one that draws 47 pictures a second"),
             choice_knob("bits", {"b"}, {"8", "4", "2", "1"}, 0, "bits a pixel"),
             toggle_knob("turn the table", "t", true, "every frame each colour moves on"),
             number_knob("speed", "-", "=", 0.1, 1, 0.1, 0.3, "/s",
                         "how often the table goes round"),
             number_knob("second table from", "Left", "Right", 0, 480, 40, 480, "lines",
                         "the line from which the controller shows other colours"),
             choice_knob("page flip", {"f"}, {"at retrace", "at once"}, 0,
                         "the ball's pages: shown whole, or torn where the beam is")}),
        seed_(setup.seed),
        monitor_(make_monitor()) {}

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  Monitor make_monitor() const {
    const auto format = kFormats[static_cast<std::size_t>(knob(kBits).index())];
    return Monitor({parse_mode("640x480@60")}, format, whole_picture(*this));
  }
  int entries() { return 1 << bits_per_pixel(monitor_.buffer().format()); }
  void resized() override { monitor_.resize(whole_picture(*this)); }

  void update(const Step& step) override {
    if (knob(kTable).on()) phase_ += knob(kSpeed).value * step.exposure.length().count();
    const std::array now = {knob(kPicture).index(), knob(kBits).index()};
    if (now == painted_) return;
    if (now[1] != painted_[1]) {
      monitor_ = make_monitor();
      monitor_.switch_on(step.exposure.begin);
    }
    painted_ = now;
    paint(monitor_.buffer().visible_page(), step.exposure.begin);
  }

  void paint(int page, Seconds now) {
    FrameBuffer& buffer = monitor_.buffer();
    const auto store = [&](int x, int y, float value) {
      const int entry = static_cast<int>(value * static_cast<float>(entries()));
      buffer.set_pixel(page, x, y, static_cast<std::uint32_t>(std::clamp(entry, 0, entries() - 1)));
    };
    const int width = buffer.width(), height = buffer.height();
    if (knob(kPicture).index() == kPlasma) paint_plasma(width, height, seed_, store);
    if (knob(kPicture).index() == kRings) paint_rings(width, height, seed_, store);
    if (knob(kPicture).index() == kBall) paint_ball(width, height, now, store);
  }

  /// The program sets the table while the beam flies up; the split is the controller's own.
  void set_table() {
    FrameBuffer& buffer = monitor_.buffer();
    const int split = static_cast<int>(knob(kSplit).value);
    buffer.clear_line_changes();
    for (int i = 0; i < entries(); ++i) {
      const double place = static_cast<double>(i) / entries();
      buffer.set_colour(i, table_colour(place + phase_, 0));
      if (split < buffer.height()) {
        buffer.set_colour_at_line(split, i, table_colour(place + phase_, 1));
      }
    }
  }

  /// The pages that the program finishes within this step, each at its own moment.
  std::vector<Monitor::Deed> page_flips(const Exposure& exposure) {
    std::vector<Monitor::Deed> flips;
    if (knob(kPicture).index() != kBall) return flips;
    const double begin = exposure.begin.count() * kPicturesPerSecond;
    for (double k = std::ceil(begin); k < exposure.end.count() * kPicturesPerSecond; ++k) {
      const Seconds when(k / kPicturesPerSecond);
      flips.push_back({when, [this, when] {
                         const int page = monitor_.buffer().hidden_page();
                         paint(page, when);
                         const bool at_retrace = knob(kFlip).index() == 0;
                         at_retrace ? monitor_.buffer().flip_at_retrace(page)
                                    : monitor_.buffer().flip_now(page);
                       }});
    }
    return flips;
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    if (monitor_.frame_begins(step)) set_table();
    monitor_.expose(step, studio().workers, picture, 0, page_flips(step.exposure));
    draw_table(picture);
  }

  void draw_table(Image<Srgb8>& picture) {
    Canvas canvas(picture);
    const float scale = theme::scale_for(height());
    const Rect bar =
        Rect{0, static_cast<float>(height()) - 92 * scale, static_cast<float>(width()), 40 * scale}
            .shrunk(theme::kMargin * scale);
    canvas.fill(bar.shrunk(-4 * scale), theme::with_alpha(theme::kPanel, 222), 4 * scale);
    const float left = std::floor(bar.x), top = std::floor(bar.y);
    const int columns = static_cast<int>(bar.width);
    for (int x = 0; x < columns; ++x) {
      const GunDrive c = monitor_.buffer().colour(x * entries() / columns);
      const Rect column{left + static_cast<float>(x), top, 1, std::floor(bar.bottom()) - top};
      canvas.fill(column, {c.r, c.g, c.b, 255});
    }
  }

  std::uint64_t seed_;
  double phase_ = 0;
  std::array<int, 2> painted_ = {-1, 0};
  Monitor monitor_;
};

}  // namespace

DemoInfo frame_buffer_demo() {
  return {
      "frame-buffer",
      "1 Displays and coordinates",
      "A colour table in motion, a table split at a line, pages flipped with and without tearing",
      [](const DemoSetup& setup) { return std::make_unique<FrameBufferDemo>(setup); },
      1,
      {},
      {"raster scan: frame buffer, refresh", "bitmap and pixmap of 1 to 8 bits"}};
}

}  // namespace kinescope
