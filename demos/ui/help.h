// The help: every key, the demo's own and those that all demos share.
#pragma once

#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/ui/layer.h"

namespace kinescope {

class Help {
 public:
  void lay(const DemoInfo& info, const Demo& demo, const Studio& studio, Image<Srgb8>& frame);

 private:
  int frame_width_ = 0, frame_height_ = 0;
  Layer layer_;
};

}  // namespace kinescope
