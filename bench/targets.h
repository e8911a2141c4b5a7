// What the rasterizer is to reach, as data: the least that counts as done.
#pragma once

#include <string>

namespace kinescope::bench {

/// Figures of one workload; 0 where there is no target.
struct Target {
  const char* workload;
  double peer_1x, peer_4x;  ///< times llvmpipe, at least
  double own_4x, own_8x;    ///< our 4 samples over our 1, our 8 over our 4, at most
};

/// Of a workload by name; of any other name, that of real meshes.
const Target& target_of(const std::string& workload);

inline constexpr double kTwoThreads = 1.85;      ///< two threads over one, at least
inline constexpr double kFirstFrame = 2.0;       ///< first frame over a steady one, at most
inline constexpr double kDepthOnlyMtris = 13.0;  ///< 10^6 triangles a second and core, at least

/// The least ratio to the peer at a sample count, or 0.
double least_ratio(const std::string& workload, int samples);

/// "met", "short", or "-" without a target.
const char* at_least(double figure, double target);
const char* at_most(double figure, double target);

}  // namespace kinescope::bench
