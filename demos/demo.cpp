#include "demos/demo.h"

#include <algorithm>

namespace kinescope {

Demo::Demo(const DemoSetup& setup, std::vector<Knob> knobs)
    : studio_(setup.studio),
      width_(setup.width),
      height_(setup.height),
      portrait_(setup.portrait),
      knobs_(std::move(knobs)) {}

Demo::Demo(const Demo&) = default;
Demo& Demo::operator=(const Demo&) = default;
Demo::~Demo() = default;

void Demo::step(const Step& step, Image<Srgb8>& picture) {
  Step left{step.exposure, {}};
  for (const InputEvent& event : step.events) {
    const auto turned = [&](Knob& knob) { return knob.answer(event.key, event.repeated); };
    if (event.kind == InputKind::kKeyDown && !typing() &&
        std::any_of(knobs_.begin(), knobs_.end(), turned)) {
      continue;
    }
    if (event.kind == InputKind::kResize) {
      width_ = event.x;
      height_ = event.y;
      resized();
    } else {
      left.events.push_back(event);
    }
  }
  update(left);
  if (picture.width() != width_ || picture.height() != height_) {
    picture = Image<Srgb8>(width_, height_);  // black where the demo draws nothing
  }
  draw(left, picture);
}

}  // namespace kinescope
