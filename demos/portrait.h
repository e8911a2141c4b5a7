// A demo as a small picture made by itself, for the gallery and its page in the documentation.
#pragma once

#include <cstdint>
#include <memory>

#include "demos/demo.h"

namespace kinescope {

class Portrait {
 public:
  /// Steps until it shows its demo well.
  static constexpr std::int64_t kFirstSteps = 4;

  Portrait() = default;
  Portrait(const DemoInfo& info, DemoSetup setup);

  bool begun() const { return demo_ != nullptr; }
  /// Whether it should be stepped even if nobody watches.
  bool unfinished() const { return steps_ < kFirstSteps; }
  /// One refresh of the demo's display.
  void step();
  /// Empty before the first step.
  const Image<Srgb8>& picture() const { return picture_; }

 private:
  std::unique_ptr<Demo> demo_;
  Seconds now_{0};
  std::int64_t steps_ = 0;
  Image<Srgb8> picture_;
};

}  // namespace kinescope
