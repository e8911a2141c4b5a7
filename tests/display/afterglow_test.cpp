// What a raster leaves behind on the glass when it moves.
#include "display/tube/afterglow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "display/raster_tube.h"
#include "tests/display/small_tube.h"

namespace kinescope {
namespace {

TEST(Afterglow, OfARollingLineIsATrailWhereItWas) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.phosphor = "P7-long";
  settings.sweep.field_hz = 55;
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  draw_line(buffer, 20);
  Workers workers(2);
  const Seconds field{1.0 / 55};
  // Drawn in one field, seen in later ones: P7's own decay, at the place of that field.
  RasterTube tube(settings, 64, 96);
  const Image<LinearRgb> drawn = tube.expose(buffer, field, workers);
  const Centre then = centre_of(drawn);
  tube.expose(black, 4 * field, workers);
  const Image<LinearRgb> trail = tube.expose(black, 5 * field, workers);
  EXPECT_NEAR(centre_of(trail).y, then.y, 0.002);
  const auto yellow = [](const Image<LinearRgb>& p) { return centre_of(p).light; };
  EXPECT_GT(yellow(trail), 0);
  // The same as a tube whose line never moved has it.
  TubeSettings steady = settings;
  steady.sweep = {};
  RasterTube locked(steady, 64, 96);
  locked.expose(buffer, field, workers);
  locked.expose(black, 4 * field, workers);
  const Image<LinearRgb> wanted = locked.expose(black, 5 * field, workers);
  EXPECT_NEAR(yellow(trail), yellow(wanted), 0.002 * yellow(wanted));
  // While it rolls on, every place that it left still glows.
  settings.phosphor = "P39";
  RasterTube rolling(settings, 64, 96);
  rolling.expose(buffer, 10 * field, workers);
  const Image<LinearRgb> seen = rolling.expose(buffer, 11 * field, workers);
  int bright_rows = 0;
  for (int y = 0; y < seen.height(); ++y) bright_rows += seen.at(32, y).g > 1e-4f;
  EXPECT_GT(bright_rows, 40);
}

TEST(Afterglow, StaysWhereItWasWhenKnobsMoveTheRaster) {
  const VideoMode mode = small_mode();
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  fill_random(buffer, 0, 8);
  Workers workers(2);
  for (const std::string phosphor : {"P1", "P22", "P7"}) {
    TubeSettings settings = fading(mode);
    settings.phosphor = phosphor;
    const Seconds then = 2.4 * mode.frame_period(), end = 2.9 * mode.frame_period();
    RasterTube turned(settings, 96, 72);
    turned.expose(buffer, then, workers);
    RasterTube left_alone = turned;
    settings.deflection.shift_x = 0.2;
    settings.deflection.keystone = 0.1;
    ASSERT_TRUE(turned.adjust(settings));
    const Image<LinearRgb> seen = turned.expose(black, end, workers);
    const Image<LinearRgb> wanted = left_alone.expose(black, end, workers);
    EXPECT_LT(largest_difference(seen, wanted), 1e-4 * largest(wanted)) << phosphor;
    EXPECT_GT(largest(wanted), 1e-3) << phosphor;
    // What is drawn from now on lies in the new place.
    RasterTube fresh(settings, 96, 72);
    fresh.expose(black, end, workers);
    const Seconds later = 6 * mode.frame_period();
    turned.expose(black, 5 * mode.frame_period(), workers);
    fresh.expose(black, 5 * mode.frame_period(), workers);
    const Image<LinearRgb> now = turned.expose(buffer, later, workers);
    const Image<LinearRgb> alone = fresh.expose(buffer, later, workers);
    if (phosphor == "P22") {
      EXPECT_LT(largest_difference(now, alone), 2e-2 * largest(alone));
    }
  }
}

TEST(Afterglow, KeepsItsPlaceWhenThePictureIsResized) {
  const VideoMode mode = small_mode();
  TubeSettings settings = fading(mode);
  settings.phosphor = "P7";
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  draw_line(buffer, 12);
  Workers workers(1);
  RasterTube tube(settings, 96, 72);
  tube.expose(buffer, mode.frame_period(), workers);
  settings.deflection.shift_y = 0.4;
  tube.adjust(settings);
  const Centre before = centre_of(tube.expose(black, 2 * mode.frame_period(), workers));
  RasterTube same = tube;
  tube.resize(192, 144);
  const Centre after = centre_of(tube.expose(black, 3 * mode.frame_period(), workers));
  const Centre as_it_was = centre_of(same.expose(black, 3 * mode.frame_period(), workers));
  EXPECT_NEAR(before.y, 12.5 / 48, 0.01);
  EXPECT_NEAR(after.y, before.y, 0.005);
  EXPECT_NEAR(after.light / 4, as_it_was.light, 0.01 * as_it_was.light);
}

}  // namespace
}  // namespace kinescope
