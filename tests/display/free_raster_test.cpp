// Sweeps that land elsewhere than the last one did, their oscillators having lost sync.
#include "display/tube/free_raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "display/raster_tube.h"
#include "tests/display/small_tube.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

constexpr int kWidth = 96, kHeight = 64;

/// A raster that the fast road for straight ones does not take, and no other difference.
TubeSettings almost_straight(const VideoMode& mode, const std::string& phosphor) {
  TubeSettings settings{mode, phosphor};
  settings.spot.sigma_mm = 12;
  settings.deflection.rotation_deg = 1e-7;
  return settings;
}

struct Hold {
  std::string phosphor;
  bool interlaced;
};
class FreeAtTheRightRate : public testing::TestWithParam<Hold> {};

/// The two share no code but the phosphor's law: one keeps cells from frame to frame, the other
/// hands each field's light over to the afterglow.
TEST_P(FreeAtTheRightRate, IsWhatTheLockedRasterIs) {
  const VideoMode mode = tiny_mode(GetParam().interlaced);
  TubeSettings settings = almost_straight(mode, GetParam().phosphor);
  RasterTube locked(settings, kWidth, kHeight);
  settings.sweep.hum_x = 1e-9;
  RasterTube free(settings, kWidth, kHeight);
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 3);
  Workers workers(2);
  const double frame = mode.horizontal.total() * mode.vertical.total();
  for (const double clock : {0.3 * frame, 1.0 * frame, 2.1 * frame, 2.1 * frame + 7.3, 3.0 * frame,
                             7.0 * frame, 7.5 * frame}) {
    const Seconds end = at_clock(mode, clock);
    const Image<LinearRgb> wanted = locked.expose(buffer, end, workers);
    const Image<LinearRgb> seen = free.expose(buffer, end, workers);
    EXPECT_LT(largest_difference(wanted, seen), 2e-3 * largest(wanted)) << clock / frame;
    EXPECT_GT(largest(wanted), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(FreeRaster, FreeAtTheRightRate,
                         testing::Values(Hold{"P22", false}, Hold{"P1", false}, Hold{"P7", false},
                                         Hold{"P4", true}, Hold{"P22", true}));

TEST(FreeRaster, SlicesAddUpToTheWhole) {
  const VideoMode mode = tiny_mode();
  TubeSettings settings = almost_straight(mode, "P7");
  settings.sweep.field_hz = 57.3;
  settings.sweep.line_hz = 1.013 * mode.line_rate_hz();
  settings.sweep.hum_x = 0.05;
  settings.sweep.hum_y = 0.03;
  settings.sweep.sag = 0.1;
  settings.gun.brightness = 0.3;  // the retrace shows
  settings.gun.sync = 0.2;
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 11);
  Workers workers(2);
  const double frame = mode.horizontal.total() * mode.vertical.total();
  const double begin = 310;
  RasterTube begun(settings, kWidth, kHeight);
  begun.expose(buffer, at_clock(mode, begin), workers);
  for (const auto& [frames, slices] : {std::pair{4.1, 90}, {1.0, kSanitized ? 500 : 10000}}) {
    RasterTube whole = begun, sliced = begun;
    LightSum one, many;
    one.add(whole.expose(buffer, at_clock(mode, begin + frames * frame), workers));
    for (int i = 1; i <= slices; ++i) {
      many.add(sliced.expose(buffer, at_clock(mode, begin + frames * frame * i / slices), workers));
    }
    expect_equal_light(one, many, 1e-5, std::to_string(slices));
  }
}

TEST(FreeRaster, AFieldRateThatIsWrongRollsThePictureAtTheDifference) {
  const VideoMode mode = small_mode();
  for (const double off_hz : {-0.7, 1.3}) {
    TubeSettings settings = fading(mode);
    settings.sweep.field_hz = 60 + off_hz;
    RasterTube tube(settings, 128, 192);
    FrameBuffer buffer = buffer_for(mode);
    draw_line(buffer, 24);
    Workers workers(1);
    // Field by field, the line lies where the video is while the sweep is there: a sweep that is
    // fast meets it later each time, further down. A turn is 60 lines of video.
    const auto line_after = [&](int fields) {
      const Seconds end{fields / settings.sweep.field_hz};
      tube.expose(buffer, end - Seconds(1 / settings.sweep.field_hz), workers);
      return centre_of(tube.expose(buffer, end, workers)).y * 48;
    };
    const double from = line_after(2), to = line_after(8);
    const double lines_a_second = (to - from) / (6 / settings.sweep.field_hz);
    // The line passes 60 times a second, a sweep (60 + off) times, at 3600 lines a second.
    const double wanted = 3600 * (1.0 / 60 - 1 / settings.sweep.field_hz) * settings.sweep.field_hz;
    EXPECT_NEAR(lines_a_second, wanted, 0.001 * std::abs(wanted) + 0.05) << off_hz;
    EXPECT_GT(std::abs(to - from), 3);
  }
}

TEST(FreeRaster, ARollComesRoundAtTheDifferenceOfTheRates) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.sweep.field_hz = 59;
  RasterTube tube(settings, 128, 192);
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 5);
  Workers workers(1);
  const Seconds field{1.0 / 59};
  tube.expose(buffer, 2 * field, workers);
  const Image<LinearRgb> first = tube.expose(buffer, 3 * field, workers);
  // 59 fields in the time of 60 frames: after a second everything is as it was, and not before.
  tube.expose(buffer, 61 * field, workers);
  const Image<LinearRgb> second = tube.expose(buffer, 62 * field, workers);
  EXPECT_LT(largest_difference(first, second), 1e-3 * largest(first));
  tube.expose(buffer, 100 * field, workers);
  EXPECT_GT(largest_difference(first, tube.expose(buffer, 101 * field, workers)),
            0.1 * largest(first));
}

TEST(FreeRaster, ALineRateThatIsWrongTearsThePictureAtTheDifference) {
  const VideoMode mode = small_mode();
  FrameBuffer buffer = buffer_for(mode);
  draw_column(buffer, 32);
  Workers workers(1);
  for (const double share : {0.995, 1.004}) {
    TubeSettings settings = fading(mode);
    settings.sweep.line_hz = share * mode.line_rate_hz();
    RasterTube tube(settings, 512, 96);
    const Image<LinearRgb> picture = tube.expose(buffer, mode.frame_period(), workers);
    // The column comes once a line of video, of 80 cells; a line of the sweep is 1 / share of that.
    double xy = 0, yy = 0;
    for (int row = 4; row < 92; row += 2) {
      const double line = (row + 1 - 48) / 2.0;
      xy += line * centre_of(picture, row, row + 2).x * 64;
      yy += line * line;
    }
    const double wanted = 80 * (share - 1);
    EXPECT_NEAR(xy / yy, wanted, 0.01 * std::abs(wanted)) << share;
  }
}

TEST(FreeRaster, ATearComesRoundAtTheDifferenceOfTheRates) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.sweep.line_hz = mode.line_rate_hz() * 239 / 240;
  RasterTube tube(settings, 256, 96);
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 9);
  Workers workers(2);
  const Seconds frame = mode.frame_period();
  tube.expose(buffer, 2 * frame, workers);
  const Image<LinearRgb> first = tube.expose(buffer, 3 * frame, workers);
  // 239 lines in the time of 240, which is four frames: ten turns later it is as it was.
  tube.expose(buffer, 42 * frame, workers);
  const Image<LinearRgb> later = tube.expose(buffer, 43 * frame, workers);
  EXPECT_LT(largest_difference(first, later), 1e-3 * largest(first));
  EXPECT_GT(largest_difference(first, tube.expose(buffer, 44 * frame, workers)),
            0.1 * largest(first));
}

}  // namespace
}  // namespace kinescope
