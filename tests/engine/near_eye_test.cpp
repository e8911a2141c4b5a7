// Down to w of a millionth: what projection, cut and rasterizer make of a triangle that reaches the
// eye's plane is the triangle in homogeneous coordinates, where nothing is cut.
#include "tests/exactness/near_eye.h"

#include <gtest/gtest.h>

namespace kinescope::exactness {
namespace {

TEST(NearEye, PicturesAgreeWithHomogeneousCoordinates) {
  Comparer comparer;
  for (const int samples : {1, 4, 8}) {
    const NearEyeTally tally = compare_near_eye(comparer, 3000 / samples, 3, samples);
    EXPECT_EQ(tally.samples_differing, 0u) << samples;
    EXPECT_EQ(tally.device.differing, 0u) << samples;
    EXPECT_GT(tally.samples, 500'000u);
    EXPECT_GT(tally.covered, 50'000u);
  }
}

}  // namespace
}  // namespace kinescope::exactness
