// A set whose holds are turned: its oscillators leave the picture's sync, and it rolls and tears.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/followed_knobs.h"
#include "demos/monitor.h"
#include "demos/tube_pictures.h"
#include "demos/ui/caption.h"
#include "demos/ui/theme.h"
#include "display/tube/preset.h"

namespace kinescope {
namespace {

enum { kSet, kPicture, kSync, kVertical, kHorizontal, kHum, kSag, kPairing, kIris };

constexpr std::array kSets = {"television-white", "television-slot", "arcade", "vga-14", "radar"};
constexpr double kRipple = 0.03;  // of half the picture's width
// How far from the sync's rate an oscillator may run and still be pulled along.
constexpr double kHoldsFields = 0.03, kHoldsLines = 0.01;

class Sync : public ClonableDemo<Sync> {
 public:
  explicit Sync(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("set", {"t"}, {kSets.begin(), kSets.end()}, 0,
                         "the tube; on the slow one a rolling picture leaves a trail"),
             choice_knob("picture", {"p"}, tube_picture_names(), 0, "what is sent to it"),
             toggle_knob("sync", "y", false,
                         "the picture's sync pulls oscillators along that are nearly right"),
             number_knob("vertical hold", "1", "2", -8, 8, 0.1, -0.4, "Hz",
                         "the field oscillator's error: the picture rolls"),
             number_knob("horizontal hold", "3", "4", -2, 2, 0.02, 0, "%",
                         "the line oscillator's error: the picture tears"),
             choice_knob("hum", {"m"}, {"none", "50 Hz", "60 Hz"}, 0,
                         "ripple of the mains in the deflection: edges bend, and wander"),
             number_knob("sag", "5", "6", 0, 0.3, 0.02, 0, "",
                         "the high voltage lost in a white picture: bright parts grow"),
             number_knob("second fields", "7", "8", -1, 1, 0.1, 0, "",
                         "how late they start, of half a line: at -1 an interlaced set pairs"),
             number_knob("iris", "-", "=", -6, 6, 1, 0, "stops",
                         "the camera's iris: each stop halves the light")}),
        monitor_(turned_settings(), PixelFormat::kXrgb8888, room()) {}

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  Rect room() const {
    const Rect all = whole_picture(*this);
    return {0, 0, all.width, std::max(1.0f, all.height - caption_room(height()))};
  }
  TubeSettings preset() const {
    return find_tube_preset(kSets[static_cast<std::size_t>(knob(kSet).index())]).settings;
  }
  static double field_rate(const VideoMode& mode) { return 1 / mode.field_period().count(); }

  TubeSettings turned_settings() const {
    TubeSettings s = preset();
    const double fields = knob(kVertical).value / field_rate(s.mode);
    const double lines = knob(kHorizontal).value / 100;
    const bool sync = knob(kSync).on();
    if (!sync || std::abs(fields) > kHoldsFields) {
      s.sweep.field_hz = field_rate(s.mode) * (1 + fields);
    }
    if (!sync || std::abs(lines) > kHoldsLines) {
      s.sweep.line_hz = s.mode.line_rate_hz() * (1 + lines);
    }
    s.sweep.hum_x = knob(kHum).index() == 0 ? 0 : kRipple;
    s.sweep.hum_hz = knob(kHum).index() == 1 ? 50 : 60;
    s.sweep.sag = knob(kSag).value;
    s.sweep.interlace_error = knob(kPairing).value;
    return s;
  }
  void resized() override { monitor_.resize(room()); }

  void update(const Step& step) override {
    if (!followed_.follow(knobs())) return;
    const bool same = monitor_.adjust(turned_settings(), step.exposure.begin);
    if (!same || followed_.turned(kPicture)) {
      monitor_.show(tube_picture(knob(kPicture).index(), preset(), studio()));
    }
  }

  std::string caption() const {
    const TubeSettings s = turned_settings();
    const double fields = field_rate(s.mode), lines = s.mode.line_rate_hz();
    const auto state = [](double own_hz, double right_hz, const char* deed) {
      if (own_hz == 0) return std::string("locked");
      const double off = own_hz - right_hz;
      if (std::abs(off) < 1e-9 * right_hz) return std::string("free, and right");
      return fmt::format("free, {:+.2f} Hz: {} once in {:.3g} s", off, deed, 1 / std::abs(off));
    };
    return fmt::format("{:.2f} fields a second {}; {:.1f} lines a second {}", fields,
                       state(s.sweep.field_hz, fields, "rolls round"), lines,
                       state(s.sweep.line_hz, lines, "tears round"));
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    std::fill(picture.pixels().begin(), picture.pixels().end(), theme::kBackground);
    monitor_.expose(step, studio().workers, picture, knob(kIris).value);
    lay_caption(picture, studio().sans, caption());
  }

  Monitor monitor_;
  FollowedKnobs followed_;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Sync>(setup); }

}  // namespace

DemoInfo sync_demo() {
  return {"sync",
          "1 Displays and coordinates",
          "Holds out of hold: a picture that rolls and tears, hums, sags and pairs its lines",
          create,
          1,
          {},
          {"raster scan: synchronization"}};
}

}  // namespace kinescope
