// A list that grows: the processor takes longer, the refresh slows down, and flicker comes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <random>
#include <vector>

#include "demos/demo.h"
#include "demos/followed_knobs.h"
#include "demos/ui/caption.h"
#include "demos/vector_monitor.h"
#include "display/phosphor.h"
#include "display/vector/segment.h"

namespace kinescope {
namespace {

enum { kVectors, kPhosphor, kSync };

constexpr std::array kPhosphors = {"P31", "P1", "P7"};
constexpr int kLow = 350, kHigh = 3740;

class DisplayFileDemo : public ClonableDemo<DisplayFileDemo> {
 public:
  explicit DisplayFileDemo(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {number_knob("vectors", "-", "=", 50, 2000, 50, 200, "", "how many the list holds"),
             choice_knob("phosphor", {"p"}, {"P31 fast", "P1 slow", "P7 long"}, 0,
                         "how long the light stays until the beam comes back"),
             toggle_knob("sync", "y", true, "the list waits for a clock of 60 Hz")}),
        seed_(setup.seed),
        monitor_(demo_machine(kPhosphors[0]), setup.width, setup.height) {
    monitor_.load("sync\nagain\n");
  }
  std::size_t state_bytes() const override { return monitor_.state_bytes(); }

 private:
  void resized() override { monitor_.resize(width(), height()); }

  void update(const Step& step) override {
    monitor_.coat(phosphor());
    bool changed = followed_.follow(knobs());
    for (const InputEvent& event : step.events) changed |= answer(event);
    if (changed) write_list();
  }
  const char* phosphor() const {
    return kPhosphors[static_cast<std::size_t>(knob(kPhosphor).index())];
  }

  /// The mouse adds a vector from where it is pressed to where it is let go.
  bool answer(const InputEvent& event) {
    const glm::vec2 at = glm::clamp(glm::vec2(monitor_.place(event.x, event.y)), 0.0f, 4095.0f);
    if (event.kind == InputKind::kMouseDown) {
      pressed_ = at;
    } else if (event.kind == InputKind::kMouseUp && pressed_) {
      added_.push_back({pressed_->x, pressed_->y, at.x, at.y});
      pressed_.reset();
      return true;
    }
    return false;
  }

  void write_list() {
    Address at = monitor_.write(0, knob(kSync).on() ? "sync" : "nop", {});
    const auto vector = [&](int x0, int y0, int x1, int y1) {
      at = monitor_.write(at, "move", {x0, y0});
      at = monitor_.write(at, "draw", {x1, y1});
    };
    std::mt19937_64 random(seed_);
    const auto place = [&] { return kLow + static_cast<int>(random() % (kHigh - kLow)); };
    const auto near = [&](int v) {
      return std::clamp(v + static_cast<int>(random() % 801) - 400, kLow, kHigh);
    };
    for (int i = 0; i < static_cast<int>(knob(kVectors).value); ++i) {
      const int x = place(), y = place();
      const int to_x = near(x), to_y = near(y);
      vector(x, y, to_x, to_y);
    }
    for (const VectorSegment& s : added_) {
      if (at + 4 >= static_cast<Address>(monitor_.machine().memory_words)) break;
      vector(static_cast<int>(s.x1), static_cast<int>(s.y1), static_cast<int>(s.x2),
             static_cast<int>(s.y2));
    }
    monitor_.write(at, "again", {});
    period_ = monitor_.period();
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture);
    const double left = find_phosphor(phosphor()).layers.back().remaining(period_);
    lay_caption(
        picture, studio().sans,
        fmt::format("{} vectors: a refresh of {:.2f} ms, {:.1f} Hz; {:.2g} % of the light "
                    "is left when the beam comes back",
                    static_cast<int>(knob(kVectors).value) + static_cast<int>(added_.size()),
                    period_.count() * 1e3, 1 / period_.count(), left * 100));
  }

  std::uint64_t seed_;
  VectorMonitor monitor_;
  FollowedKnobs followed_;
  std::vector<VectorSegment> added_;
  std::optional<glm::vec2> pressed_;
  Seconds period_{0};
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<DisplayFileDemo>(setup);
}

}  // namespace

DemoInfo display_file_demo() {
  return {"display-file",
          "1 Displays and coordinates",
          "A list of vectors that grows until its refresh slows down and flickers",
          create,
          1,
          "drag to add a vector",
          {"random scan: display file, display processor, refresh falling as the list grows"}};
}

}  // namespace kinescope
