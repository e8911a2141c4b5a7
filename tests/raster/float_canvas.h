// A rasterizer with a target of floats, which a test reads.
#pragma once

#include <span>
#include <variant>

#include "raster/rasterizer.h"

namespace kinescope {

using Floats = Image<LinearRgba>;

/// A rasterizer with a float target.
struct FloatCanvas {
  FloatCanvas(int width, int height, int samples = 1)
      : workers(2),
        rasterizer(workers),
        target(width, height, samples, ColourFormat::kLinearFloat) {}
  RasterStats draw(std::span<const DrawCall> calls) { return rasterizer.draw(target, calls); }
  const LinearRgba& at(int x, int y) const { return std::get<Floats>(target.colour).at(x, y); }

  Workers workers;
  Rasterizer rasterizer;
  RenderTarget target;
};

}  // namespace kinescope
