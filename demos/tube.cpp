// A tube with every knob within reach, from its video amplifier to its glass.
#include <array>
#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/followed_knobs.h"
#include "demos/monitor.h"
#include "demos/tube_dials.h"
#include "demos/tube_pictures.h"
#include "display/tube/preset.h"

namespace kinescope {
namespace {

enum { kTube, kPicture, kMask, kMagnify, kIris, kDials };

constexpr double kTimes[] = {1, 4, 16};

/// Masks as they were sold.
constexpr MaskSettings kMasks[] = {{MaskKind::kNone},
                                   {MaskKind::kDots, 0.31, 0.8},
                                   {MaskKind::kGrille, 0.25, 0.8},
                                   {MaskKind::kSlots, 0.75, 0.8, 0.9, 0.18}};

std::vector<std::string> tube_names() {
  std::vector<std::string> names;
  for (const TubePreset& preset : tube_presets()) names.push_back(preset.name);
  return names;
}

int index_of(std::string_view name) {
  int index = 0;
  while (tube_presets()[static_cast<std::size_t>(index)].name != name) ++index;
  return index;
}

std::vector<Knob> all_knobs() {
  std::vector<Knob> knobs = {
      choice_knob("tube", {"t"}, tube_names(), index_of("vga-14"),
                  "the preset that all other knobs start from"),
      choice_knob("picture", {"p"}, tube_picture_names(), 0, "what it shows"),
      choice_knob("mask", {"m"},
                  {"its own", "none", "dots 0.31 mm", "grille 0.25 mm", "slots 0.75 mm"}, 0,
                  "the shadow mask of a colour tube"),
      choice_knob("magnifier", {"z"}, {"none", "4 x", "16 x"}, 0, "a closer look at the middle"),
      number_knob("iris", "-", "=", -6, 6, 1, 0, "stops",
                  "the camera's iris: each stop halves the light")};
  for (const TubeDial& d : tube_dials()) {
    knobs.push_back(number_knob(std::string(d.name), std::string(d.down), std::string(d.up),
                                d.least, d.most, d.step, d.start, std::string(d.unit),
                                std::string(d.about)));
  }
  return knobs;
}

class Tube : public ClonableDemo<Tube> {
 public:
  explicit Tube(const DemoSetup& setup)
      : ClonableDemo(setup, all_knobs()),
        monitor_(turned_settings(), PixelFormat::kXrgb8888, whole_picture(*this)) {}

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  std::size_t choice(int index) const { return static_cast<std::size_t>(knob(index).index()); }

  TubeSettings turned_settings() const {
    TubeSettings settings = tube_presets()[choice(kTube)].settings;
    if (choice(kMask) > 0) settings.mask = kMasks[choice(kMask) - 1];
    int index = kDials;
    for (const TubeDial& dial : tube_dials()) dial.turn(settings, knob(index++).value);
    return magnified(settings, kTimes[choice(kMagnify)]);
  }
  void resized() override { monitor_.resize(whole_picture(*this)); }

  void update(const Step& step) override {
    if (!followed_.follow(knobs())) return;
    const bool same = monitor_.adjust(turned_settings(), step.exposure.begin);
    if (!same || followed_.turned(kPicture)) {
      const TubeSettings& preset = tube_presets()[choice(kTube)].settings;
      monitor_.show(tube_picture(knob(kPicture).index(), preset, studio()));
    }
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture, knob(kIris).value);
  }

  Monitor monitor_;
  FollowedKnobs followed_;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Tube>(setup); }

}  // namespace

DemoInfo tube_demo() {
  return {"tube",
          "1 Displays and coordinates",
          "One tube, and every knob there is: video, beam, deflection, mask and glass",
          create,
          1,
          {},
          {"CRT: focus, deflection and every other setting with its figure"}};
}

}  // namespace kinescope
