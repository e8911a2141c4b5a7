// What the tests of demos share: a small setup, and runs of steps.
#pragma once

#include <gtest/gtest.h>
#include <set>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "demos/picture.h"
#include "demos/player.h"
#include "demos/registry.h"

namespace kinescope {

inline const std::shared_ptr<Studio>& test_studio() {
  static const auto studio = std::make_shared<Studio>(2);
  return studio;
}

inline DemoSetup small_setup(int width = 160, int height = 120) {
  return {test_studio(), width, height, 1};
}

inline InputEvent key_down(const std::string& key) {
  InputEvent event;
  event.kind = InputKind::kKeyDown;
  event.key = key;
  return event;
}

inline InputEvent mouse_event(InputKind kind, int x, int y, MouseButton button = MouseButton::kNone,
                              float wheel = 0) {
  InputEvent event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  event.button = button;
  event.wheel = wheel;
  return event;
}

/// The length of a step as the window would make it at the demo's first time scale.
inline Seconds step_length(const DemoInfo& info, const Demo& demo) {
  return demo.refresh().period() * info.time_scale;
}

/// One test a demo, named by it.
class EveryDemo : public ::testing::TestWithParam<std::string> {
 protected:
  const DemoInfo& info() const { return find_demo(GetParam()); }
};

inline std::vector<std::string> demo_names() {
  std::vector<std::string> names;
  for (const DemoInfo& info : all_demos()) names.emplace_back(info.name);
  return names;
}

inline std::string test_name(const ::testing::TestParamInfo<std::string>& demo) {
  std::string name = demo.param;
  std::erase(name, '-');
  return name;
}

/// How many colours there are within [x0, x1) by [y0, y1).
inline std::size_t distinct_colours(const Image<Srgb8>& picture, int x0, int y0, int x1, int y1) {
  std::set<std::uint32_t> seen;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const Srgb8 c = picture.at(x, y);
      seen.insert(static_cast<std::uint32_t>(c.r << 16 | c.g << 8 | c.b));
    }
  }
  return seen.size();
}

}  // namespace kinescope
