// The small line at the bottom: what runs, how fast its time passes, how often it is drawn.
#pragma once

#include <string>

#include "demos/studio.h"
#include "demos/ui/layer.h"

namespace kinescope {

class Hud {
 public:
  struct Content {
    std::string name, time_scale;
    int frames_per_second = 0;
    bool paused = false;
    std::string message;  ///< for a short while: what was just saved
    bool has_knobs = true;
    bool operator==(const Content&) const = default;
  };
  void lay(const Content& content, const Studio& studio, Image<Srgb8>& frame);

 private:
  void draw(const Studio& studio, int width, int height);

  Content content_;
  int frame_width_ = 0, frame_height_ = 0;
  Layer layer_;
};

}  // namespace kinescope
