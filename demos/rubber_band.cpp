// A line that follows the hand while it is being placed: one instruction is edited as it is drawn.
#include <algorithm>
#include <cmath>

#include "demos/demo.h"
#include "demos/pen_hand.h"
#include "demos/vector_monitor.h"

namespace kinescope {
namespace {

enum { kShape, kGrid, kSpacing };

constexpr int kMost = 4095;
constexpr Address kBand = 1, kBandWords = 6, kGridCall = kBand + kBandWords, kFixed = kGridCall + 1;
constexpr Address kGridPoints = 6000;  // a subroutine, away from the list

class RubberBand : public ClonableDemo<RubberBand> {
 public:
  explicit RubberBand(const DemoSetup& setup)
      : ClonableDemo(setup, {choice_knob("shape", {"r"}, {"line", "box"}, 0, "what is stretched"),
                             toggle_knob("grid", "g", true, "ends jump to the points of a grid"),
                             number_knob("spacing", "-", "=", 128, 1024, 128, 512, "units",
                                         "from one point of the grid to the next")}),
        monitor_(demo_machine("P31"), setup.width, setup.height) {
    monitor_.load("sync\nnop\nnop\nnop\nnop\nnop\nnop\nnop\nagain\n");
  }
  std::size_t state_bytes() const override { return monitor_.state_bytes(); }

 private:
  void resized() override { monitor_.resize(width(), height()); }

  std::int64_t snapped(double v) const {
    const double by = knob(kGrid).on() ? knob(kSpacing).value : 1;
    return std::clamp<std::int64_t>(std::llround(v / by) * std::llround(by), 0, kMost);
  }

  void update(const Step& step) override {
    const Rect whole{0, 0, static_cast<float>(width()), static_cast<float>(height())};
    const bool drew = hand_.draws;
    for (const InputEvent& event : step.events) {
      hand_.answer(event, whole);
      if (event.kind == InputKind::kMouseDown) anchor_ = here();
      if (event.kind == InputKind::kMouseUp && drew) fix();
    }
    if (!hand_.mouse) hand_.move_by_itself(step.exposure.begin);
    write_grid();
    Address at = kBand;
    if (hand_.draws) at = write_shape(at);
    while (at < kGridCall) at = monitor_.write(at, "nop", {});
  }
  glm::dvec2 here() const {
    return monitor_.place(static_cast<int>((hand_.place.x + 1) * 0.5 * width()),
                          static_cast<int>((hand_.place.y + 1) * 0.5 * height()));
  }

  Address write_shape(Address at) {
    const std::int64_t x0 = snapped(anchor_.x), y0 = snapped(anchor_.y);
    const std::int64_t x1 = snapped(here().x), y1 = snapped(here().y);
    at = monitor_.write(at, "move", {x0, y0});
    if (knob(kShape).index() == 0) return monitor_.write(at, "draw", {x1, y1});
    at = monitor_.write(at, "draw", {x1, y0});
    at = monitor_.write(at, "draw", {x1, y1});
    at = monitor_.write(at, "draw", {x0, y1});
    return monitor_.write(at, "draw", {x0, y0});
  }
  /// What was stretched stays in the list, as long as there is room.
  void fix() {
    if (fixed_ + kBandWords >= kGridPoints) return;
    fixed_ = write_shape(fixed_);
    monitor_.write(fixed_, "again", {});
  }
  void write_grid() {
    if (!knob(kGrid).on()) {
      monitor_.write(kGridCall, "nop", {});
      return;
    }
    monitor_.write(kGridCall, "call", {kGridPoints});
    Address at = kGridPoints;
    const auto by = std::llround(knob(kSpacing).value);
    for (std::int64_t y = by; y < kMost; y += by) {
      for (std::int64_t x = by; x < kMost; x += by) at = monitor_.write(at, "point", {x, y});
    }
    monitor_.write(at, "return", {});
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture);
  }

  VectorMonitor monitor_;
  PenHand hand_;
  glm::dvec2 anchor_{1024, 1024};
  Address fixed_ = kFixed;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<RubberBand>(setup); }

}  // namespace

DemoInfo rubber_band_demo() {
  return {"rubber-band",
          "1 Displays and coordinates",
          "A line that follows the hand until it is let go, snapped to a grid",
          create,
          1,
          "drag to draw",
          {"random scan: a display file edited as it is drawn"}};
}

}  // namespace kinescope
