// Shadow masks side by side: dots that can be counted, and ones finer than the picture's pixels.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/followed_knobs.h"
#include "demos/monitor.h"
#include "demos/tube_dials.h"
#include "demos/ui/theme.h"
#include "display/patterns/patterns.h"

namespace kinescope {
namespace {

enum { kWhich, kTriad, kLight, kCurved, kOpen, kIris };

constexpr double kCurvature = 1.5;  // radius of the curved glass, diagonals of what is seen
constexpr double kEvenSpot = 3;     // deviation, lines: they run into each other

struct NamedMask {
  const char* name;
  MaskSettings mask;
};
constexpr std::array kMasks{NamedMask{"none", {}}, NamedMask{"dots", {MaskKind::kDots, 0.31}},
                            NamedMask{"grille", {MaskKind::kGrille, 0.25}},
                            NamedMask{"slots", {MaskKind::kSlots, 0.75, 0, 0.9, 0.18}}};

class Masks : public ClonableDemo<Masks> {
 public:
  explicit Masks(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("mask", {"1", "2", "3", "4", "5"},
                         {"all four", "none", "dots", "grille", "slots"}, 0, "which are shown"),
             number_knob("triad", "-", "=", 0.7, 24, 0.1, 8, "px",
                         "how large a triad is in the picture: from 2 px on it can be seen"),
             choice_knob("light", {"l"}, {"even", "lines", "grey steps", "zone plate"}, 1,
                         "what falls on it: white without lines, white with them, a pattern"),
             toggle_knob("curved", "c", false, "a bulging glass: triads shrink towards its edge"),
             number_knob("open", "o", "p", 0.1, 1, 0.05, 0.8, "",
                         "how much of its place each opening fills"),
             number_knob("iris", "9", "0", -4, 4, 1, 1, "stops",
                         "the camera's iris: each stop halves the light")}) {}

  std::size_t state_bytes() const override {
    std::size_t sum = 0;
    for (const Pane& pane : panes_) sum += pane.monitor.state_bytes();
    return sum;
  }

 private:
  struct Pane {
    const NamedMask* mask;
    Rect label;
    Monitor monitor;
  };

  /// The middle of a tube of 13 inches, as close as shows triads of that size; or a larger tube.
  TubeSettings settings(const NamedMask& named, float width_px) const {
    TubeSettings s{mode_};
    s.mask = named.mask;
    s.mask.open = knob(kOpen).value;
    const double line_mm = s.glass.diagonal_mm * 0.6 / s.mode.vertical.active;
    if (knob(kLight).index() == 0) s.spot.sigma_mm = kEvenSpot * line_mm;
    const double width_mm = static_cast<double>(width_px) * s.mask.pitch_mm / knob(kTriad).value;
    const double diagonal_mm = 1.25 * width_mm;  // 5 to 4
    if (diagonal_mm < s.glass.diagonal_mm) s = magnified(s, s.glass.diagonal_mm / diagonal_mm);
    s.glass.diagonal_mm = diagonal_mm;
    s.glass.distance_mm = 3 * diagonal_mm;
    if (knob(kCurved).on()) s.glass.curvature_mm = kCurvature * diagonal_mm;
    return s;
  }

  void resized() override { followed_.forget(); }

  void update(const Step& step) override {
    if (!followed_.follow(knobs())) return;
    const bool laid = !followed_.turned(kWhich);
    if (!laid) lay_panes();
    for (Pane& pane : panes_) {
      pane.monitor.adjust(settings(*pane.mask, pane.monitor.face().width), step.exposure.begin);
      if (!laid) pane.monitor.switch_on(step.exposure.begin);
      if (followed_.turned(kLight) || !laid) pane.monitor.show(light());
    }
  }

  void lay_panes() {
    panes_.clear();
    const int which = knob(kWhich).index();
    const int across = which == 0 ? 2 : 1;
    const auto wide = static_cast<float>(width() / across);
    const float scale = theme::scale_for(height()), label = 2 * theme::kBody * scale;
    const int all = height() - static_cast<int>(theme::kWindowLine * scale);
    const auto high = static_cast<float>(std::max(0, all / across));
    for (int i = 0; i < across * across; ++i) {
      const NamedMask& mask = kMasks[static_cast<std::size_t>(which == 0 ? i : which - 1)];
      const float x = static_cast<float>(i % across) * wide,
                  y = static_cast<float>(i / across) * high;
      const Rect room = Rect{x, y, wide, std::max(0.0f, high - label)}.shrunk(label * 0.15f);
      panes_.push_back({&mask,
                        {x, y + high - label, wide, label},
                        Monitor({mode_}, PixelFormat::kXrgb8888, room)});
    }
  }

  Image<Srgb8> light() const {
    const int width = mode_.horizontal.active, height = mode_.vertical.active;
    if (knob(kLight).index() == 2) return grey_steps(width, height);
    if (knob(kLight).index() == 3) return zone_plate(width, height);
    return {width, height, {255, 255, 255, 255}};
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    std::fill(picture.pixels().begin(), picture.pixels().end(), theme::kBackground);
    Canvas canvas(picture);
    const float size = theme::kBody * theme::scale_for(height());
    for (Pane& pane : panes_) {
      pane.monitor.expose(step, studio().workers, picture, knob(kIris).value);
      const MaskSettings& mask = pane.mask->mask;
      std::string text = pane.mask->name;
      if (mask.kind != MaskKind::kNone) {
        text += fmt::format(", {:g} mm: {:.1f} px a triad", mask.pitch_mm, knob(kTriad).value);
      }
      canvas.text(studio().sans, {pane.label.x + pane.label.width / 2, pane.label.y + 1.2f * size},
                  text, size, theme::kText, Align::kCentre);
    }
  }

  VideoMode mode_ = parse_mode("640x480@60");
  std::vector<Pane> panes_;
  FollowedKnobs followed_;
};

}  // namespace

DemoInfo masks_demo() {
  return {"masks",
          "1 Displays and coordinates",
          "Dots, stripes and slots, from triads that can be counted to an even tint",
          [](const DemoSetup& setup) { return std::make_unique<Masks>(setup); },
          1,
          {},
          {"CRT: shadow masks and aperture grilles"}};
}

}  // namespace kinescope
