// The test patterns of the trade, each at the size of the tube's mode.
#include <array>

#include "demos/demo.h"
#include "demos/monitor.h"
#include "display/patterns/patterns.h"
#include "display/video_mode.h"

namespace kinescope {
namespace {

enum { kPattern, kMode };

constexpr std::array kModes = {"640x480@60", "240p", "ntsc", "pal"};

std::vector<std::string> pattern_names() {
  std::vector<std::string> names;
  for (const TestPattern& pattern : test_patterns()) names.emplace_back(pattern.name);
  return names;
}

std::vector<std::string> pattern_keys() {
  std::vector<std::string> keys;
  for (std::size_t i = 1; i <= test_patterns().size(); ++i) keys.push_back(std::to_string(i));
  return keys;
}

class TestPatterns : public ClonableDemo<TestPatterns> {
 public:
  explicit TestPatterns(const DemoSetup& setup)
      : ClonableDemo(setup, {choice_knob("pattern", pattern_keys(), pattern_names(), 0,
                                         "what the generator sends to the guns"),
                             choice_knob("mode", {"m"}, {kModes.begin(), kModes.end()}, 0,
                                         "how the tube scans it")}),
        monitor_(make_monitor()) {}

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  Monitor make_monitor() const {
    const char* const mode = kModes[static_cast<std::size_t>(knob(kMode).index())];
    return Monitor({parse_mode(mode)}, PixelFormat::kXrgb8888, whole_picture(*this));
  }
  void resized() override { monitor_.resize(whole_picture(*this)); }

  void update(const Step& step) override {
    const std::array now = {knob(kPattern).index(), knob(kMode).index()};
    if (now == shown_) return;
    if (now[1] != shown_[1]) {
      monitor_ = make_monitor();
      monitor_.switch_on(step.exposure.begin);
    }
    shown_ = now;
    const TestPattern& pattern = test_patterns()[static_cast<std::size_t>(now[0])];
    monitor_.show(pattern.draw(monitor_.buffer().width(), monitor_.buffer().height()));
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture);
  }

  Monitor monitor_;
  std::array<int, 2> shown_{-1, -1};
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<TestPatterns>(setup);
}

}  // namespace

DemoInfo test_patterns_demo() {
  return {"test-patterns",
          "1 Displays and coordinates",
          "Colour bars, PLUGE, crosshatch, zone plate, grey steps and dots on four rasters",
          create,
          1,
          {},
          {"resolution", "aspect ratio"}};
}

}  // namespace kinescope
