// Triangles that reach the eye's plane and behind it, through the pipeline's projection and cut.
#pragma once

#include "tests/exactness/compare.h"

namespace kinescope::exactness {

/// Figures of the picture against the triangle in homogeneous coordinates, where nothing is cut.
struct NearEyeTally {
  Tally device;               ///< what was left of the triangles, against CoverageOracle
  std::uint64_t samples = 0;  ///< compared in homogeneous coordinates
  std::uint64_t covered = 0;  ///< of these, covered
  std::uint64_t samples_differing = 0;
};

/// `count` random triangles with w from a millionth to a hundred, on either side of the eye.
///
/// A sample counts in homogeneous coordinates if it lies further than snapping reaches from every
/// edge and from the cuts of the near and far planes. Source: M. Olano and T. Greer, "Triangle scan
/// conversion using 2D homogeneous coordinates", 1997.
NearEyeTally compare_near_eye(Comparer& comparer, int count, unsigned seed, int samples);

}  // namespace kinescope::exactness
