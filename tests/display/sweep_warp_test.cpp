// What disturbs a sweep: hum, a high voltage that sags, fields that pair.
#include "display/tube/sweep_warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "display/raster_tube.h"
#include "display/tube/deflection.h"
#include "tests/display/small_tube.h"

namespace kinescope {
namespace {

TEST(SweepWarp, HumSwingsThePictureWithTheMains) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.sweep.hum_x = 0.1;
  settings.sweep.hum_hz = 60;  // as the picture: it stands still
  FrameBuffer buffer = buffer_for(mode);
  draw_column(buffer, 31);
  Workers workers(1);
  RasterTube tube(settings, 256, 96);
  const Image<LinearRgb> picture = tube.expose(buffer, mode.frame_period(), workers);
  for (const int row : {10, 30, 50, 70}) {
    const double line = (row + 1) * 48.0 / 96 - 0.5;
    const double swing = 0.05 * std::sin(2 * M_PI * line / 60);
    EXPECT_NEAR(centre_of(picture, row, row + 2).x, 31.5 / 64 + swing, 0.002) << row;
  }
}

TEST(SweepWarp, AHighVoltageThatSagsBloomsTheLinesBelowWhite) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.deflection.width = 0.8;
  settings.sweep.sag = 0.2;
  settings.sweep.sag_time_s = 1e-4;  // two lines
  FrameBuffer buffer = buffer_for(mode);
  draw_column(buffer, 60);
  for (int y = 10; y < 30; ++y) {
    for (int x = 0; x < 64; ++x) buffer.set_pixel(0, x, y, kWhite);
  }
  Workers workers(1);
  RasterTube tube(settings, 512, 96);
  tube.expose(buffer, mode.frame_period(), workers);
  const Image<LinearRgb> picture = tube.expose(buffer, 2 * mode.frame_period(), workers);
  // The right edge of a line of white lies further out, by the square root of the voltage lost.
  const auto edge = [&](int row) {
    int x = picture.width() - 1;
    const float half = 0.5f * picture.at(256, 40).g;
    while (x > 0 && picture.at(x, row).g < half) --x;
    return (x + 0.5) / picture.width() * 2 - 1;
  };
  const double load = 48.0 / 60;  // steady white's is 1, with its retrace
  EXPECT_NEAR(edge(50), 0.8 / std::sqrt(1 - 0.2 / load), 0.02);
  // And where little is drawn, it lies where it should.
  EXPECT_NEAR(centre_of(picture, 88, 92).x, 0.5 + 0.8 * (60.5 / 64 - 0.5), 0.004);
}

TEST(SweepWarp, AHighVoltageThatSagsWidensTheSpot) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.deflection.width = 0.8;
  settings.spot.sigma_mm = 1;
  settings.spot.astigmatism = 2;
  settings.sweep.sag = 0.2;
  settings.sweep.sag_time_s = 1e-4;
  FrameBuffer buffer = buffer_for(mode);
  draw_column(buffer, 31);
  for (int y = 10; y < 30; ++y) {
    for (int x = 0; x < 64; ++x) buffer.set_pixel(0, x, y, kWhite);
  }
  Workers workers(1);
  // Of the column, just below the white, where the voltage is still low.
  const auto variance = [&](double sag_power, int row) {
    settings.spot.sag_power = sag_power;
    RasterTube tube(settings, 512, 384);
    tube.expose(buffer, mode.frame_period(), workers);
    const Image<LinearRgb> picture = tube.expose(buffer, 2 * mode.frame_period(), workers);
    double light = 0, x1 = 0, x2 = 0;
    for (int x = 0; x < 512; ++x) {
      const double here = static_cast<double>(picture.at(x, row).g);
      light += here;
      x1 += here * x;
      x2 += here * x * x;
    }
    return x2 / light - x1 * x1 / (light * light);
  };
  const double spot_pixels =
      settings.spot.astigmatism * pixels_a_mm(settings.glass, 512, 384).across;
  // Lines feel what was drawn four lines before them: the first four below the white feel it all.
  // Line 32, which the voltage moves down, too.
  const int below = static_cast<int>(384 * (0.5 + 8.5 / 48 / std::sqrt(1 - 0.2 * 60.0 / 48)));
  const int far = (46 * 384) / 48;
  const double wanted = spot_pixels * spot_pixels * (1 / (1 - 0.2 * 60.0 / 48) - 1);
  EXPECT_NEAR(variance(0.5, below) - variance(0, below), wanted, 0.1 * wanted);
  EXPECT_NEAR(variance(0.5, far), variance(0, far), 0.02 * spot_pixels * spot_pixels);
}

TEST(SweepWarp, SecondFieldsThatAreEarlyPairTheLines) {
  const VideoMode mode = small_mode(true);
  TubeSettings settings = fading(mode);
  settings.spot.sigma_mm = 0.8;
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  Workers workers(1);
  // Light along a column: 48 lines lie apart, 24 pairs when second fields are half a line early.
  const auto ripple = [&](double error) {
    settings.sweep.interlace_error = error;
    RasterTube tube(settings, 16, 48 * 8);
    const Image<LinearRgb> picture = tube.expose(buffer, mode.frame_period(), workers);
    double sum_48 = 0, sum_24 = 0;
    for (int y = 64; y < 320; ++y) {
      const double light = static_cast<double>(picture.at(8, y).g);
      sum_48 += light * std::cos(2 * M_PI * (y + 0.5) / 8);
      sum_24 += light * std::cos(2 * M_PI * (y + 0.5) / 16 - M_PI / 2);
    }
    return std::pair(std::abs(sum_48), std::abs(sum_24));
  };
  const auto [apart_48, apart_24] = ripple(0);
  EXPECT_LT(apart_24, 0.02 * apart_48);
  const auto [paired_48, paired_24] = ripple(-1);
  EXPECT_GT(paired_24, 0.5 * apart_48);
}

}  // namespace
}  // namespace kinescope
