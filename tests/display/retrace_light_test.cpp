#include "display/tube/retrace_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

TEST(RetraceLight, RepeatedExcitationGivesOneAPeriodAndAddsUp) {
  for (const double tau : {0.01, 3.0, 500.0}) {
    EXPECT_NEAR(light_of_repeated(0.3, 10, 10, tau), 1, 1e-12);
    const double whole = light_of_repeated(2, 7, 10, tau);
    EXPECT_NEAR(light_of_repeated(2, 3, 10, tau) + light_of_repeated(5, 4, 10, tau), whole, 1e-12);
    // Many periods of single pulses, summed.
    double sum = 0;
    for (int n = 0; n < 4000; ++n) {
      sum += std::exp(-(4 + 10.0 * n) / tau) - std::exp(-(6 + 10.0 * n) / tau);
    }
    EXPECT_NEAR(light_of_repeated(4, 2, 10, tau), sum, 1e-9);
  }
}

/// A green picture of a black frame, brightness as given.
Image<LinearRgb> black_frame(double brightness, Seconds begin_phase, Seconds length) {
  TubeSettings settings;
  settings.mode = parse_mode("640x480@60");
  settings.phosphor = "P31";
  settings.gun.brightness = brightness;
  FrameBuffer buffer = buffer_for(settings.mode);
  RasterTube tube(settings, 320, 240);
  Workers workers(2);
  const Seconds begin = 40 * settings.mode.frame_period() + begin_phase;
  tube.expose(buffer, begin, workers);
  return tube.expose(buffer, begin + length, workers);
}

TEST(RetraceLight, IsDarkUntilBrightnessOvercomesBlanking) {
  const Seconds frame = parse_mode("640x480@60").frame_period();
  const Image<LinearRgb> black = black_frame(0, Seconds(0), frame);
  for (const LinearRgb& p : black.pixels()) ASSERT_EQ(p.g, 0);
  // Above black the raster glows evenly, but nothing else does.
  const Image<LinearRgb> grey = black_frame(0.1, Seconds(0), frame);
  EXPECT_NEAR(grey.at(160, 120).g, std::pow(0.1, 2.35), 0.2 * std::pow(0.1, 2.35));
}

TEST(RetraceLight, ShowsTheFlightBackUpAsSteepLines) {
  const VideoMode mode = parse_mode("640x480@60");
  const Image<LinearRgb> picture = black_frame(0.35, Seconds(0), mode.frame_period());
  // Down a column, retrace lines stand out over the even raster: about one for each line of
  // vertical sync and back porch.
  int peaks = 0;
  float mean = 0;
  for (int y = 0; y < 240; ++y) mean += picture.at(100, y).g / 240;
  for (int y = 1; y < 239; ++y) {
    const float here = picture.at(100, y).g;
    peaks +=
        here > 1.05f * mean && here >= picture.at(100, y - 1).g && here > picture.at(100, y + 1).g;
  }
  EXPECT_GE(peaks, 20);  // those near the ends run together
  EXPECT_LE(peaks, 40);
}

TEST(RetraceLight, AddsUpOverSlices) {
  const VideoMode mode = parse_mode("640x480@60");
  const Seconds frame = mode.frame_period();
  const Image<LinearRgb> whole = black_frame(0.3, 0.2 * frame, 0.7 * frame);
  const Image<LinearRgb> first = black_frame(0.3, 0.2 * frame, 0.3 * frame);
  const Image<LinearRgb> second = black_frame(0.3, 0.5 * frame, 0.4 * frame);
  for (std::size_t i = 0; i < whole.pixels().size(); i += 37) {
    ASSERT_NEAR(first.pixels()[i].g + second.pixels()[i].g, whole.pixels()[i].g, 1e-4) << i;
  }
}

}  // namespace
}  // namespace kinescope
