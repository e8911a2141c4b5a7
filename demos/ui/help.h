// The help: every key, the demo's own and those that all demos share.
#pragma once

#include <string>
#include <vector>

#include <span>

#include "demos/demo.h"
#include "demos/ui/layer.h"

namespace kinescope {

class Help {
 public:
  /// @param knobs may be none: then there is no panel
  void lay(const DemoInfo& info, std::span<const Knob> knobs, const Studio& studio,
           Image<Srgb8>& frame);

 private:
  int frame_width_ = 0, frame_height_ = 0;
  Layer layer_;
};

}  // namespace kinescope
