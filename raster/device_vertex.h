// A vertex as the rasterizer takes it.
#pragma once

namespace kinescope {

/// A projected vertex. Device space: pixels, y down, the centre of the top left pixel at
/// (0.5, 0.5). Sixteen bytes in one place, since triangles read all of them in any order.
struct alignas(16) DeviceVertex {
  /// The rasterizer is exact for coordinates in [-kGuardBand, kGuardBand] pixels.
  static constexpr float kGuardBand = 32768.0f;

  float x_px = 0, y_px = 0;
  float z = 0;      ///< depth, 0 near to 1 far, linear in device space
  float inv_w = 1;  ///< 1 / w of clip space, positive

  bool operator==(const DeviceVertex&) const = default;
};

}  // namespace kinescope
