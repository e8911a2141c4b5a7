// The same workloads drawn by Mesa's llvmpipe, through EGL without a window.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bench/triangle_pass.h"
#include "bench/workloads.h"
#include "raster/image/image.h"

namespace kinescope::bench {

/// A workload held by OpenGL: static buffers, the same lights, texture and culling, an RGBA8 colour
/// and a 32-bit float depth buffer of 1 or 4 samples, resolved at the end of a frame. A material
/// that is not opaque is blended as submitted, without writing depth.
class LlvmpipePeer {
 public:
  static constexpr int kMaxSamples = 4;

  /// Call before the first peer is made: how many threads llvmpipe rasterizes with.
  static void set_threads(int threads);

  /// @param triangles  show the triangles' numbers instead of the workload's colours
  /// @throws Error if EGL gives no llvmpipe context
  LlvmpipePeer(const Workload& workload, int width, int height, int samples,
               std::optional<TriangleColours> triangles = {});
  ~LlvmpipePeer();
  LlvmpipePeer(const LlvmpipePeer&) = delete;
  LlvmpipePeer& operator=(const LlvmpipePeer&) = delete;

  /// Renderer and version, as OpenGL names itself.
  std::string version() const;
  /// Draws and waits until the frame is whole. @return milliseconds
  double draw(const Camera& camera);
  /// The last frame, rows from the top.
  Image<Linear8> picture() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope::bench
