// A light pen on a raster tube: what it draws, it knows from the time of the light that it saw.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "demos/demo.h"
#include "demos/monitor.h"
#include "demos/pen_chart.h"
#include "demos/pen_drawing.h"
#include "demos/pen_hand.h"
#include "demos/ui/theme.h"

namespace kinescope {
namespace {

enum { kGround, kView, kThreshold, kRise, kCorrect, kPhosphor, kHold, kSignal };

constexpr std::array kPhosphors = {"P22", "P4", "P31", "P1"};
constexpr std::uint32_t kInk = 0xffe0a0;
constexpr Seconds kForgotten(0.1);  // after which a stroke begins anew

std::vector<Knob> all_knobs() {
  return {number_knob("ground", "1", "2", 0, 1, 0.05, 0.5, "",
                      "drive of the bare screen: of a dark one the pen sees nothing"),
          number_knob("view", "3", "4", 0.25, 8, 0.25, 1, "mm",
                      "what the pen sees: beyond a line's height it tells lines above"),
          number_knob("threshold", "5", "6", 0.02, 1, 0.02, 0.1, "",
                      "the light that trips it, a white line's being 1"),
          number_knob("rise", "7", "8", 50, 1000, 50, 100, "ns", "by how much its amplifier lags"),
          toggle_knob("delay corrected", "d", true, "the lag taken off before the pixel is told"),
          choice_knob("phosphor", {"p"}, {"P22 colour", "P4 white", "P31 green", "P1 slow green"},
                      0, "what glows, and for how long"),
          number_knob("vertical hold", "9", "0", -2, 2, 0.1, 0, "Hz",
                      "the picture rolls below the pen, which still tells what it sees"),
          toggle_knob("signal", "g", true, "what the photodiode saw, against time")};
}

class LightPenRaster : public ClonableDemo<LightPenRaster> {
 public:
  explicit LightPenRaster(const DemoSetup& setup)
      : ClonableDemo(setup, all_knobs()),
        monitor_(tube(), PixelFormat::kXrgb8888, whole_picture(*this)),
        pen_(tube(), held()) {}

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  TubeSettings tube() const {
    TubeSettings tube{parse_mode("640x480@60"),
                      kPhosphors[static_cast<std::size_t>(knob(kPhosphor).index())]};
    const double off_hz = knob(kHold).value;
    if (off_hz != 0) tube.sweep.field_hz = 1 / tube.mode.field_period().count() + off_hz;
    return tube;
  }
  LightPenSettings held() const {
    return {hand_.place, knob(kView).value, knob(kThreshold).value,
            Seconds(knob(kRise).value * 1e-9)};
  }
  std::uint32_t ground() const {
    return static_cast<std::uint32_t>(std::lround(knob(kGround).value * 255)) * 0x010101;
  }
  void resized() override { monitor_.resize(whole_picture(*this)); }

  void update(const Step& step) override {
    const bool another = knob(kPhosphor).index() != phosphor_;
    phosphor_ = knob(kPhosphor).index();
    monitor_.adjust(tube(), step.exposure.begin);
    if (another || ground_ != ground()) clear();
    for (const InputEvent& event : step.events) hand_.answer(event, monitor_.face());
    if (!hand_.mouse) hand_.move_by_itself(step.exposure.begin);
    pen_ = LightPen(tube(), held());
    if (const FreeSweep* sweep = monitor_.free_sweep()) pen_.follow(*sweep);
  }

  /// The bare screen; what was drawn is gone.
  void clear() {
    ground_ = ground();
    FrameBuffer& buffer = monitor_.buffer();
    for (int y = 0; y < buffer.height(); ++y) {
      for (int x = 0; x < buffer.width(); ++x) store_square(buffer, x, y, 0, *ground_);
    }
    sight_.reset();
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    // Pen and chart may lie beside the tube, where it draws nothing.
    std::fill(picture.pixels().begin(), picture.pixels().end(), theme::kBackground);
    monitor_.expose(step, studio().workers, picture);
    const Exposure passed{monitor_.tube_time(step.exposure.begin),
                          monitor_.tube_time(step.exposure.end)};
    if (const auto tripped = pen_.watch(monitor_.buffer(), passed)) see(*tripped);
    const PenChart chart{pen_, studio(), sight_};
    Canvas canvas(picture);
    chart.draw_view(canvas, monitor_.face(), hand_.draws || hand_.rubs);
    const auto w = static_cast<float>(width()), h = static_cast<float>(height());
    if (knob(kSignal).on()) chart.draw_signal(canvas, {w * 0.52f, h * 0.82f, w * 0.46f, h * 0.16f});
  }

  /// The pen tells a time; the controller makes a pixel of it, and the program draws there.
  void see(Seconds tripped) {
    const Seconds taken_off = knob(kCorrect).on() ? Seconds(0) : pen_.delay();
    PenSight sight{tripped, pen_.address(tripped + taken_off),
                   pen_.record(monitor_.buffer(), PenChart::shown(tripped))};
    if (hand_.draws || hand_.rubs) {
      const bool goes_on = sight_ && pressed_ && tripped - sight_->tripped < kForgotten;
      store_stroke(monitor_.buffer(), goes_on ? sight_->address : sight.address, sight.address,
                   hand_.rubs ? 5 : 1, hand_.rubs ? *ground_ : kInk);
    }
    pressed_ = hand_.draws || hand_.rubs;
    sight_ = std::move(sight);
  }
  Monitor monitor_;
  PenHand hand_;
  LightPen pen_;
  int phosphor_ = 0;
  std::optional<std::uint32_t> ground_;  // what the screen was cleared to
  std::optional<PenSight> sight_;
  bool pressed_ = false;  // when the pen last tripped
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<LightPenRaster>(setup);
}

}  // namespace

DemoInfo light_pen_raster_demo() {
  return {"light-pen-raster",
          "1 Displays and coordinates",
          "A pen that draws where it sees the beam pass: an address found from time alone",
          create,
          1,
          "left: draw, right: rub out",
          {"input: light pen"}};
}

}  // namespace kinescope
