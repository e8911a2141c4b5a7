// What a demo draws a scene with. Nothing in it outlives a step, so copies of a demo share it.
#pragma once

#include "engine/renderer.h"

namespace kinescope {

struct Easel {
  explicit Easel(Workers& workers) : renderer(workers) {}

  /// The target, of the size and samples asked for.
  RenderTarget& prepare(int width, int height, int samples) {
    if (target.width != width || target.height != height || target.samples != samples) {
      target = RenderTarget(width, height, samples);
    }
    return target;
  }

  Renderer renderer;
  RenderTarget target;
};

}  // namespace kinescope
