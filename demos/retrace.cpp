// The beam's journey: along a line, back blanked, and from the last line up again.
#include <algorithm>
#include <array>

#include "demos/beam_chart.h"
#include "demos/demo.h"
#include "demos/monitor.h"
#include "demos/test_card.h"
#include "display/video_mode.h"

namespace kinescope {
namespace {

enum { kRaster, kPhosphor, kPath, kCharts, kGuide, kIris, kBrightness };

constexpr double kFirstTimeScale = 1.0 / 500;
constexpr float kChartShare = 0.25f;  // of the picture's height
constexpr int kGuideShare = 9;        // one part in so many of the picture's codes
constexpr Srgb8 kSurround{10, 10, 12, 255};

// 48 lines at 60 Hz, so coarse that one line of it can be watched.
constexpr std::array kModes = {"640x480@60", "Modeline \"64x48\" 0.264 64 66 74 80 48 49 51 55",
                               "Modeline \"64x48i\" 0.264 64 66 74 80 48 49 51 55 interlace"};
constexpr std::array kPhosphors = {"P22", "P4", "P31", "P1"};

class Retrace : public ClonableDemo<Retrace> {
 public:
  explicit Retrace(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("raster", {"r"}, {"640 x 480", "64 x 48", "64 x 48 interlaced"}, 0,
                         "lines as of a VGA monitor, or few enough to watch one"),
             choice_knob("phosphor", {"p"},
                         {"P22 colour", "P4 white", "P31 green", "P1 slow green"}, 0,
                         "what glows, and for how long"),
             toggle_knob("path", "o", true, "the beam's way, blanked parts dashed"),
             toggle_knob("charts", "c", true, "deflection and blanking against time"),
             toggle_knob("guide", "g", true, "the whole picture, faint, as the eye adds it up"),
             number_knob("iris", "-", "=", -6, 6, 1, 0, "stops",
                         "the camera's iris: each stop halves the light"),
             number_knob("brightness", "1", "2", 0, 0.5, 0.05, 0, "",
                         "added to the video: beyond the blanking the way back shows")}),
        monitor_(make_monitor()) {}

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  Rect room() const {
    const Rect whole = whole_picture(*this);
    const float share = knob(kCharts).on() ? kChartShare : 0;
    // Room round the picture shows where the beam overshoots it.
    return Rect{0, 0, whole.width, whole.height * (1 - share)}.shrunk(whole.height * 0.025f);
  }
  TubeSettings settings() const {
    TubeSettings settings{parse_mode(kModes[static_cast<std::size_t>(knob(kRaster).index())])};
    settings.phosphor = kPhosphors[static_cast<std::size_t>(knob(kPhosphor).index())];
    settings.gun.brightness = knob(kBrightness).value;
    return settings;
  }
  Monitor make_monitor() const { return Monitor(settings(), PixelFormat::kXrgb8888, room()); }
  void resized() override { monitor_.resize(room()); }

  void update(const Step& step) override {
    monitor_.adjust(settings(), step.exposure.begin);
    if (knob(kCharts).on() != charts_) {
      charts_ = knob(kCharts).on();
      monitor_.resize(room());
    }
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    const VideoMode& mode = monitor_.scan().mode();
    if (card_.width() != mode.horizontal.active) {
      card_ = test_card(studio(), mode.horizontal.active, mode.vertical.active);
    }
    if (monitor_.frame_begins(step)) monitor_.show(card_);
    std::fill(picture.pixels().begin(), picture.pixels().end(), kSurround);
    monitor_.expose(step, studio().workers, picture, knob(kIris).value);
    if (knob(kGuide).on()) draw_guide(picture);
    const BeamChart chart{monitor_.scan(), studio(), monitor_.tube_time(step.exposure.begin),
                          monitor_.tube_time(step.exposure.end)};
    Canvas canvas(picture);
    if (knob(kPath).on()) chart.draw_path(canvas, monitor_.face());
    if (!knob(kCharts).on()) return;
    const float top = static_cast<float>(height()) * (1 - kChartShare);
    chart.draw_charts(canvas,
                      {0, top, static_cast<float>(width()), static_cast<float>(height()) - top});
  }

  /// Adds a part of the card's codes to those of the light.
  void draw_guide(Image<Srgb8>& picture) const {
    const Rect& face = monitor_.face();
    const int left = static_cast<int>(face.x), top = static_cast<int>(face.y);
    const int width = static_cast<int>(face.width), height = static_cast<int>(face.height);
    const auto add = [](std::uint8_t& light, int code) {
      light = static_cast<std::uint8_t>(std::min(255, light + code / kGuideShare));
    };
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Srgb8 c = card_.at(x * card_.width() / width, y * card_.height() / height);
        Srgb8& light = picture.at(left + x, top + y);
        add(light.r, c.r), add(light.g, c.g), add(light.b, c.b);
      }
    }
  }

  bool charts_ = true;
  Monitor monitor_;
  Image<Srgb8> card_;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Retrace>(setup); }

}  // namespace

DemoInfo retrace_demo() {
  return {"retrace",
          "1 Displays and coordinates",
          "Time slowed down until the beam is seen to draw, fly back and fly up",
          create,
          kFirstTimeScale,
          {},
          {"CRT: gun, focus, deflection, phosphor: a beam seen in slow time",
           "raster scan: horizontal and vertical retrace, interlace"}};
}

}  // namespace kinescope
