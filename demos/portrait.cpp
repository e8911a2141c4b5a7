#include "demos/portrait.h"

#include <utility>
#include <vector>

namespace kinescope {

Portrait::Portrait(const DemoInfo& info, DemoSetup setup) {
  setup.portrait = true;
  demo_ = info.create(setup);
}

void Portrait::step() {
  std::vector<InputEvent> events;
  // In its first step a demo makes what the keys then lead through.
  if (steps_ == 1) {
    for (const std::string_view key : demo_->portrait_keys()) {
      InputEvent event;
      event.kind = InputKind::kKeyDown;
      event.key = key;
      events.push_back(std::move(event));
    }
  }
  const Seconds end = now_ + demo_->refresh().period();
  demo_->step({{now_, end}, std::move(events)}, picture_);
  now_ = end;
  ++steps_;
}

}  // namespace kinescope
