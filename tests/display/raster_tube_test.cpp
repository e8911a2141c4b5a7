#include "display/raster_tube.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "display/decay.h"

namespace kinescope {
namespace {

/// 12x8 pixels in 20x11 clocks, 60 frames a second: every interval is there, and a line lasts long
/// enough for a phosphor to fade within it.
VideoMode tiny_mode(bool interlaced = false) {
  VideoMode mode;
  mode.name = "tiny";
  mode.horizontal = {12, 2, 3, 3};
  mode.vertical = {8, 1, 1, 1};
  mode.interlaced = interlaced;
  mode.pixel_clock_hz = 20 * 11 * 60;
  return mode;
}

FrameBuffer white_buffer(const VideoMode& mode) {
  FrameBuffer buffer(mode.horizontal.active, mode.vertical.active, PixelFormat::kXrgb8888);
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) {
      for (int page = 0; page < buffer.pages(); ++page) buffer.set_pixel(page, x, y, 0xffffff);
    }
  }
  return buffer;
}

TEST(RasterTube, SmallSteadyWhiteIsOneInBothScans) {
  for (const bool interlaced : {false, true}) {
    const VideoMode mode = tiny_mode(interlaced);
    FrameBuffer buffer = white_buffer(mode);
    RasterTube tube({mode, "P31"}, 24, 16);
    Workers workers(1);
    tube.expose(buffer, 30 * mode.frame_period(), workers);
    double sum = 0;
    for (const LinearRgb& p : tube.expose(buffer, 31 * mode.frame_period(), workers).pixels()) {
      sum += p.g;
    }
    EXPECT_NEAR(sum / (24 * 16), 1.0, 1e-5);
  }
}

double mean_green(const Image<LinearRgb>& picture) {
  double sum = 0;
  for (const LinearRgb& p : picture.pixels()) sum += p.g;
  return sum / static_cast<double>(picture.pixels().size());
}

TEST(RasterTube, SteadyWhiteIsOne) {
  const VideoMode mode = parse_mode("640x480@60");
  FrameBuffer buffer = white_buffer(mode);
  RasterTube tube({mode}, 320, 240);
  Workers workers(2);
  const Seconds frame = mode.frame_period();
  for (int n = 1; n <= 10; ++n) tube.expose(buffer, n * frame, workers);
  const Image<LinearRgb>& picture = tube.expose(buffer, 11 * frame, workers);
  EXPECT_NEAR(mean_green(picture), 1.0, 1e-4);
  EXPECT_NEAR(picture.at(160, 120).r, 1.0, 1e-3);
  EXPECT_NEAR(picture.at(160, 120).b, 1.0, 1e-3);
}

}  // namespace
}  // namespace kinescope
