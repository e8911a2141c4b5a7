// A light pen on a vector display: the processor tells which instruction drew what the pen saw, and
// so which part of the picture it points at.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <map>

#include "demos/demo.h"
#include "demos/pen_hand.h"
#include "demos/pen_parts.h"
#include "demos/ui/caption.h"
#include "demos/ui/theme.h"
#include "demos/vector_monitor.h"

namespace kinescope {
namespace {

enum { kField, kCross, kAddress };

class LightPenDemo : public ClonableDemo<LightPenDemo> {
 public:
  explicit LightPenDemo(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {number_knob("field", "1", "2", 20, 120, 10, 60, "units", "what the pen sees"),
                      toggle_knob("cross", "c", true, "a cross that follows the pen"),
                      toggle_knob("address", "a", true, "what the processor reports")}),
        monitor_(demo_machine("P31"), setup.width, setup.height) {
    names_ = monitor_.load(kPenParts).names;
  }
  std::size_t state_bytes() const override { return monitor_.state_bytes(); }

 private:
  Address at(const char* name) const { return static_cast<Address>(names_.at(name)); }
  void resized() override { monitor_.resize(width(), height()); }

  void update(const Step& step) override {
    const Rect whole{0, 0, static_cast<float>(width()), static_cast<float>(height())};
    for (const InputEvent& event : step.events) hand_.answer(event, whole);
    if (!hand_.mouse) hand_.move_by_itself(step.exposure.begin);
    pen_ = monitor_.place(static_cast<int>((hand_.place.x + 1) * 0.5 * width()),
                          static_cast<int>((hand_.place.y + 1) * 0.5 * height()));
    monitor_.hold_pen(BeamPen{pen_.x, pen_.y, knob(kField).value});
    if (!hand_.draws) held_.reset();
    // A press puts the cross below the pen, as a hand does that begins with it.
    if (hand_.draws && !pressed_) cross_ = pen_;
    pressed_ = hand_.draws;
    place("cross", cross_);
    if (knob(kCross).on()) {
      monitor_.write(at("aim"), "call", {at("arms")});
    } else {
      monitor_.write(at("aim"), "nop", {});
    }
  }
  void place(const char* name, glm::dvec2 to) { place(at(name), to); }
  void place(Address move, glm::dvec2 to) {
    const auto whole = [](double v) { return std::clamp<std::int64_t>(std::llround(v), 0, 4095); };
    monitor_.write(move, "move", {whole(to.x), whole(to.y)});
  }

  /// What this refresh's hits tell: where the pen is in the cross, and which part it points at.
  void read_hits() {
    double reach[4] = {};
    bool seen = false;
    const char* const arms[] = {"right", "left", "up", "down"};
    for (const BeamPenHit& hit : monitor_.hits()) {
      if (hit.address >= at("arms")) {
        int arm = 3;
        while (hit.address < at(arms[arm])) --arm;
        const double far = std::hypot(hit.x - cross_.x, hit.y - cross_.y);
        reach[arm] = std::max(reach[arm], far);
        seen = true;
      } else if (!hit.calls.empty()) {
        hit_ = hit;
        if (hand_.draws && !held_) held_ = hit.calls.front() - 1;
      }
    }
    const glm::dvec2 step{0.5 * (reach[0] - reach[1]), 0.5 * (reach[2] - reach[3])};
    cross_ = knob(kCross).on() ? cross_ + step : pen_;
    // A hand that lost the cross goes back for it.
    if (!seen && !hand_.mouse) pressed_ = false;
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    const glm::dvec2 before = cross_;
    monitor_.expose(step, studio().workers, picture);
    read_hits();
    if (held_) drag(cross_ - before);
    Canvas canvas(picture);
    const glm::vec2 tip = monitor_.pixel(pen_.x, pen_.y);
    const auto radius = static_cast<float>(knob(kField).value * monitor_.pixels_a_unit());
    canvas.frame({tip.x - radius, tip.y - radius, 2 * radius, 2 * radius}, 1, theme::kAccent,
                 radius);
    if (!knob(kAddress).on()) return;
    lay_caption(picture, studio().mono,
                hit_ ? report() : std::string("the pen has seen nothing yet"));
  }
  std::string report() const {
    return fmt::format("the pen saw {:#06x}: {}, called from {:#06x}: {}", hit_->address,
                       monitor_.text_at(hit_->address), hit_->calls.front(),
                       monitor_.text_at(hit_->calls.front()));
  }
  /// The part goes where the cross goes.
  void drag(glm::dvec2 by) {
    glm::dvec2& offset = offsets_[*held_];
    if (offset == glm::dvec2(0)) {
      int x = 0, y = 0;
      std::sscanf(monitor_.text_at(*held_).c_str(), "move %d %d", &x, &y);
      offset = {x, y};
    }
    offset = glm::clamp(offset + by, glm::dvec2(0), glm::dvec2(3400));
    place(*held_, offset);
  }

  VectorMonitor monitor_;
  std::map<std::string, std::int64_t> names_;
  PenHand hand_;
  glm::dvec2 pen_{0}, cross_{2048};
  bool pressed_ = false;
  std::optional<BeamPenHit> hit_;
  std::optional<Address> held_;            // the move that places the part
  std::map<Address, glm::dvec2> offsets_;  // where parts were dragged to
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<LightPenDemo>(setup);
}

}  // namespace

DemoInfo light_pen_demo() {
  return {"light-pen",
          "1 Displays and coordinates",
          "A pen that finds the instruction that drew what it sees, and drags the part",
          create,
          1,
          "drag a part",
          {"input: light pen"}};
}

}  // namespace kinescope
