// The panel: a demo's knobs, shown and turned with the mouse.
#pragma once

#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/ui/layer.h"

namespace kinescope {

class Panel {
 public:
  void lay(const DemoInfo& info, const Demo& demo, const Studio& studio, Image<Srgb8>& frame);
  /// Whether a place in the frame lies on the panel.
  bool contains(int x, int y) const;
  /// The key presses that a click there stands for; of a drag's move, only on numbers' tracks.
  std::vector<std::string> click(int x, int y, std::span<const Knob> knobs,
                                 bool drag = false) const;

 private:
  /// A place to click, in pixels of the layer, and the value that it turns a knob to.
  struct Target {
    Rect rect;
    std::size_t knob;
    double value;
  };
  class Painter;

  std::vector<double> values_;  // as drawn
  int frame_width_ = 0, frame_height_ = 0;
  Layer layer_;
  std::vector<Target> targets_;
};

}  // namespace kinescope
