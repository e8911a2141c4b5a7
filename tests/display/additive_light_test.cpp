// The law of additive time: slices sum to the whole.
#include "display/raster_tube.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "display/phosphor.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"
#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

/// Total light of [0, 1 s) in the given number of exposures; the picture changes at every retrace.
LightSum light_in_slices(const VideoMode& mode, const TubeSettings& settings, int slices, int width,
                         int height) {
  FrameBuffer buffer = buffer_for(mode, 2);
  fill_random(buffer, 0, 1);
  fill_random(buffer, 1, 2);
  buffer.flip_at_retrace(1);
  RasterTube tube(settings, width, height);
  Workers workers(1);
  LightSum sum;
  for (int i = 1; i <= slices; ++i) {
    sum.add(tube.expose(buffer, Seconds(static_cast<double>(i) / slices), workers));
  }
  return sum;
}

TEST(AdditiveLight, OneSecondIsTheSumOfItsSlices) {
  for (const bool interlaced : {false, true}) {
    for (const char* phosphor : {"P22", "P1", "P31", "P7-long"}) {
      const VideoMode mode = tiny_mode(interlaced);
      const TubeSettings settings{mode, phosphor};
      const LightSum whole = light_in_slices(mode, settings, 1, 17, 13);
      for (const int slices : {7, 60, 1000}) {
        expect_equal_light(whole, light_in_slices(mode, settings, slices, 17, 13), 1e-5,
                           std::string(phosphor) + " in " + std::to_string(slices));
      }
    }
  }
}

TEST(AdditiveLight, OneSecondOfATelevisionIsTheSumOfItsSlices) {
  VideoMode mode = parse_mode("ntsc");
  mode.horizontal = {45, 2, 5, 6};
  mode.vertical = {32, 1, 2, 2};
  mode.pixel_clock_hz = 58 * 37 * 30;
  const TubeSettings settings{mode};
  const LightSum whole = light_in_slices(mode, settings, 1, 64, 48);
  for (const int slices : {7, 60, 1000}) {
    expect_equal_light(whole, light_in_slices(mode, settings, slices, 64, 48), 1e-5,
                       std::to_string(slices));
  }
}

TEST(AdditiveLight, TenThousandSlicesOfAFrameAddUp) {
  for (const char* phosphor : {"P22", "P1"}) {
    const VideoMode mode = tiny_mode();
    FrameBuffer buffer = buffer_for(mode);
    fill_random(buffer, 0, 5);
    RasterTube tube = cell_tube(mode, phosphor);
    Workers workers(1);
    const double begin = 3 * 220 + 31.7;
    tube.expose(buffer, at_clock(mode, begin), workers);
    RasterTube sliced = tube;
    LightSum whole, sum;
    whole.add(tube.expose(buffer, at_clock(mode, begin + 220), workers));
    for (int i = 1; i <= 10000; ++i) {
      sum.add(sliced.expose(buffer, at_clock(mode, begin + 220 * i / 10000.0), workers));
    }
    expect_equal_light(whole, sum, 1e-5, phosphor);
  }
}

}  // namespace
}  // namespace kinescope
