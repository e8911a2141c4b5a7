// Which triangle shows where: a picture of triangle numbers, drawn by our pipeline.
#pragma once

#include <cstdint>
#include <memory>

#include "bench/workloads.h"
#include "raster/draw_call.h"
#include "raster/image/image.h"

namespace kinescope::bench {

/// How a triangle's number becomes a colour. The background is black.
enum class TriangleColours {
  kNumber,  ///< number + 1, eight bits a channel: tells triangles apart exactly at one sample
  kMixed    ///< red full, green and blue scattered: the mean of samples tells coverage and owners
};
Linear8 colour_of_triangle(std::uint32_t triangle, TriangleColours colours);

/// A workload's only mesh, projected and cut for one camera.
class TrianglePass {
 public:
  TrianglePass(const Workload& workload, const Camera& camera, int width, int height);
  ~TrianglePass();

  Image<Linear8> picture(int samples, TriangleColours colours) const;

  /// How a triangle of the mesh meets a pixel's centre.
  struct Meeting {
    bool covered = false;
    float depth = 1;
    double edge_256ths = 0;  ///< how far the nearest edge's line is, in 256ths of a pixel
  };
  Meeting meet(std::uint32_t triangle, int x, int y) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope::bench
