#include "display/tube/retrace_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "display/tube/video_signal.h"
#include "tests/display/small_tube.h"

namespace kinescope {
namespace {

TEST(RetraceLight, RepeatedExcitationGivesOneAPeriodAndAddsUp) {
  for (const double tau : {0.01, 3.0, 500.0}) {
    for (const double dwell : {0.01, 3.0}) {
      EXPECT_NEAR(light_of_repeated(0.3, 10, 10, dwell, tau), 1, 1e-12);
      const double whole = light_of_repeated(1, 9.5, 10, dwell, tau);
      EXPECT_NEAR(
          light_of_repeated(1, 4, 10, dwell, tau) + light_of_repeated(5, 5.5, 10, dwell, tau),
          whole, 1e-12);
    }
    // Many flashes, each with all its periods, summed.
    constexpr int kFlashes = 300'000;
    double periods = 0;
    for (int n = 1; n < 4000; ++n) periods += std::exp(-10.0 * n / tau);
    double sum = 0;
    for (int i = 0; i < kFlashes; ++i) {
      const double flash = 3 * (i + 0.5) / kFlashes;
      if (flash < 2) sum += 1 - std::exp(-(2 - flash) / tau);
      if (flash < 1) sum -= 1 - std::exp(-(1 - flash) / tau);
      // Those a period and more ago: their light in [1, 2), times what the periods have left.
      sum += periods * (std::exp(-(1 - flash) / tau) - std::exp(-(2 - flash) / tau));
    }
    EXPECT_NEAR(light_of_repeated(1, 1, 10, 3, tau), sum / kFlashes, 1e-9);
  }
}

TEST(VideoSignal, SyncTipsAreALinesPulseAndBroadOnesInVerticalSync) {
  const VideoMode mode = parse_mode("640x480@60");
  const auto clocks_low = [&](int line) {
    int low = 0;
    for (int pixel = 0; pixel < 800; ++pixel) low += in_sync_tip(mode, line * 800 + pixel + 0.5);
    return low;
  };
  for (const int line : {0, 240, 479, 489, 492, 524}) EXPECT_EQ(clocks_low(line), 96) << line;
  for (const int line : {490, 491}) EXPECT_EQ(clocks_low(line), 800 - 2 * 96) << line;
  EXPECT_FALSE(in_sync_tip(mode, 655.5));
  EXPECT_TRUE(in_sync_tip(mode, 656.5));
  // The same, as a sweep at nine tenths of the speed meets them.
  std::vector<CellSpan> tips;
  find_sync_tips(mode, 5 * 525 * 800 + 600, 1 / 0.9, 640, tips);
  ASSERT_EQ(tips.size(), 1u);
  EXPECT_NEAR(tips[0].begin, 56 * 0.9, 1);
  EXPECT_NEAR(tips[0].end - tips[0].begin, 96 * 0.9, 1);
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

/// Where a brightly raised black raster's light lies at a moment, of a tube that fades at once.
Centre light_at(TubeSettings settings, Seconds at, Seconds length) {
  settings.gun.brightness = 0.4;
  FrameBuffer buffer = buffer_for(settings.mode);
  RasterTube tube(settings, 64, 192);
  Workers workers(1);
  tube.expose(buffer, at, workers);
  return centre_of(tube.expose(buffer, at + length, workers));
}

TEST(RetraceLight, SyncTipsAreDarkAndTheRestShows) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  // The beam's pieces are taken as flashes, so windows hold them whole.
  const auto light = [&](double line, double pixel, double length) {
    return light_at(settings, at_clock(mode, line * 80 + pixel), at_clock(mode, length)).light;
  };
  // Within the glass: in vertical sync and back porch, in horizontal sync and back porch.
  const double vertical = light(53, 0, 8), up = light(56, 0, 8);
  const double horizontal = light(20, 68, 6), back = light(20, 74, 6);
  EXPECT_GT(up, 0);
  EXPECT_NEAR(vertical, up, 0.1 * up);  // sync has wires of its own
  EXPECT_GT(horizontal, 0.7 * back);
  settings.gun.sync = 0.4;
  EXPECT_NEAR(light(56, 0, 8), up, 0.05 * up);
  EXPECT_LT(light(53, 0, 8), 0.02 * up);
  EXPECT_GT(light(53, 22, 6), 0.5 * up);  // between two broad pulses
  EXPECT_LT(light(20, 68, 6), 0.5 * back);
  EXPECT_NEAR(light(20, 74, 6), back, 0.2 * back);
}

TEST(RetraceLight, OfAFreeRasterFliesBackWhenItsOwnSweepDoes) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.sweep.field_hz = 50;  // of 72 lines, the last 9 fly back
  const Seconds line = at_clock(mode, 80);
  // Video is in the middle of its picture then, the beam on its way up from the raster's bottom.
  double last = 2;
  for (const double of_flight : {0.2, 0.5, 0.8}) {
    const Seconds at = 2 * Seconds(1.0 / 50) - 9 * (1 - of_flight) * line;
    const Centre free = light_at(settings, at, line);
    EXPECT_GT(free.light, 0);
    const double lines = 63 * (0.5 + 0.5 * std::cos(M_PI * (of_flight + 0.5 / 9)));
    if (lines < 46) {
      EXPECT_NEAR(free.y, lines / 48, 0.06) << of_flight;
    }
    EXPECT_LT(free.y, last);
    last = free.y;
  }
  // While video retraces, the beam draws black, where the raster's brightness shows evenly.
  const Centre drawn = light_at(settings, at_clock(mode, (60 + 55) * 80), line);
  EXPECT_NEAR(drawn.y, (115 - 72 + 0.5) / 48, 0.02);
}

TEST(RetraceLight, OfAFreeRasterAtTheRightRateIsTheLockedOnes) {
  const VideoMode mode = small_mode();
  for (const char* phosphor : {"P22", "P7", "P1"}) {
    TubeSettings settings{mode, phosphor};
    settings.spot.sigma_mm = 3;
    settings.glass.curvature_mm = 900;
    settings.gun.brightness = 0.35;
    settings.gun.sync = 0.05;
    RasterTube locked(settings, 96, 72);
    settings.sweep.hum_x = 1e-9;
    RasterTube free(settings, 96, 72);
    FrameBuffer buffer = buffer_for(mode);
    Workers workers(1);
    const Seconds frame = mode.frame_period();
    for (const double end : {12.0, 13.0, 13.4}) {
      const Image<LinearRgb> wanted = locked.expose(buffer, end * frame, workers);
      const Image<LinearRgb> seen = free.expose(buffer, end * frame, workers);
      if (end > 12) {
        EXPECT_LT(largest_difference(wanted, seen), 0.03 * largest(wanted)) << phosphor << end;
      }
    }
  }
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
