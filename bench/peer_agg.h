// Anti-Grain Geometry's outline renderer as a peer.
#pragma once

#include <memory>
#include <span>

#include "raster/image/image.h"
#include "raster/path/line_kernel.h"

namespace kinescope::bench {

/// Draws lines with rasterizer_outline_aa and renderer_outline_aa, on one thread (it has no more).
class AggLines {
 public:
  AggLines(int width, int height, float width_px);
  ~AggLines();

  void draw(std::span<const InkedLine> lines);
  void clear();
  Image<Linear8> picture() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope::bench
