// The rasterizer's fast path against the oracle, sample by sample.
#pragma once

#include <cstdint>

#include "raster/rasterizer.h"

namespace kinescope::exactness {

struct Tally {
  std::uint64_t triangles = 0;
  std::uint64_t samples = 0;  ///< that the oracle decided: those of each box, and a ring around it
  std::uint64_t differing = 0;  ///< triangles
  Tally& operator+=(const Tally& o) {
    triangles += o.triangles;
    samples += o.samples;
    differing += o.differing;
    return *this;
  }
};

/// Draws triangles and compares. Keeps its rasterizer between pictures.
class Comparer {
 public:
  Comparer() : rasterizer_(workers_) {}

  /// No two triangles of the call may cover the same sample, and all depths are kDepth: then the
  /// hash of what is visible is a sum over what each triangle covers, and covers the whole target:
  /// a sample too many, too few or covered twice changes it. Differing triangles are then found one
  /// by one, and printed to stderr.
  Tally compare(const DrawCall& call, int width, int height, int samples);

  static constexpr float kDepth = 0.5f;

 private:
  std::uint64_t drawn_hash(const DrawCall& call, int width, int height, int samples);
  std::uint64_t count_differing(const DrawCall& call, int width, int height, int samples);

  Workers workers_{1};
  Rasterizer rasterizer_;
  RenderTarget target_;
};

}  // namespace kinescope::exactness
