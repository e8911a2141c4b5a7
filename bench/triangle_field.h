// Triangles of one size at random places of the device, without a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/draw_call.h"

namespace kinescope::bench {

/// Right triangles that share no vertex, facing the eye, at random depths.
class TriangleField {
 public:
  /// @param leg_px  length of both legs
  TriangleField(int count, float leg_px, int width, int height);

  /// Depth and visibility only: nothing is shaded.
  DrawCall call() const;
  int count() const { return static_cast<int>(indices_.size() / 3); }

 private:
  std::vector<DeviceVertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace kinescope::bench
