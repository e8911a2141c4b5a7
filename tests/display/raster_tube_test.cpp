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

TEST(RasterTube, SteadyWhiteIsOne) {
  const VideoMode mode = parse_mode("640x480@60");
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube({mode}, 320, 240);
  Workers workers(2);
  const Seconds frame = mode.frame_period();
  for (int n = 1; n <= 12; ++n) tube.expose(buffer, n * frame, workers);
  const Image<LinearRgb>& picture = tube.expose(buffer, 13 * frame, workers);
  double sum = 0;
  for (int y = 5; y < 235; ++y) {
    for (int x = 5; x < 315; ++x) sum += static_cast<double>(picture.at(x, y).g);
  }
  EXPECT_NEAR(sum / (230 * 310), 1.0, 1e-5);
  for (int y = 5; y < 235; ++y) {
    for (const int x : {5, 160, 314}) {
      const LinearRgb p = picture.at(x, y);
      ASSERT_NEAR(p.r, 1, 1e-3) << x << "," << y;
      ASSERT_NEAR(p.g, 1, 1e-3) << x << "," << y;
      ASSERT_NEAR(p.b, 1, 1e-3) << x << "," << y;
    }
  }
}

TEST(RasterTube, SteadyWhiteIsOneFromAnyPhaseInEveryScanAndPhosphor) {
  Workers workers(1);
  for (const bool interlaced : {false, true}) {
    for (const char* phosphor : {"P22", "P1", "P4", "P31"}) {
      const VideoMode mode = tiny_mode(interlaced);
      FrameBuffer buffer = buffer_for(mode);
      fill(buffer, 0, kWhite);
      RasterTube tube = cell_tube(mode, phosphor);
      const double frame = 220;
      tube.expose(buffer, at_clock(mode, 60 * frame + 77.3), workers);
      for (const LinearRgb& p :
           tube.expose(buffer, at_clock(mode, 61 * frame + 77.3), workers).pixels()) {
        ASSERT_NEAR(std::max({p.r, p.g, p.b}), 1, 2e-6) << phosphor << " " << interlaced;
      }
    }
  }
}

TEST(RasterTube, AResetTubeReadsAPictureThatDidNotChangeAnew) {
  const VideoMode mode = tiny_mode();
  const Seconds frame = mode.frame_period();
  Workers workers(1);
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube = cell_tube(mode, "P31");
  tube.expose(buffer, frame, workers);
  const Image<LinearRgb> first = tube.expose(buffer, 2 * frame, workers);
  tube.reset();
  tube.expose(buffer, frame, workers);
  const Image<LinearRgb>& again = tube.expose(buffer, 2 * frame, workers);
  ASSERT_GT(first.at(1, 1).g, 0.1f);
  for (std::size_t i = 0; i < first.pixels().size(); ++i) {
    ASSERT_EQ(again.pixels()[i].g, first.pixels()[i].g) << i;
  }
}

TEST(RasterTube, ARefreshedPictureOfEveryPhosphorReachesASteadyState) {
  const VideoMode mode = tiny_mode();
  const Seconds frame = mode.frame_period();
  Workers workers(1);
  for (const PhosphorType& type : phosphors()) {
    double longest = 0, late = 0;  // late: share of the light that takes longer than what is waited
    for (const Phosphor& layer : type.layers) {
      for (const DecayTerm& term : layer.terms) longest = std::max(longest, term.tau.count());
    }
    const double frames = std::ceil(std::max(1.0, std::min(60.0, 16 * longest)) / frame.count());
    for (const Phosphor& layer : type.layers) {
      late = std::max(late, layer.remaining(frames * frame));
    }
    FrameBuffer buffer = buffer_for(mode);
    fill(buffer, 0, kWhite);
    RasterTube tube = cell_tube(mode, type.name);
    tube.expose(buffer, frames * frame, workers);
    const Image<LinearRgb> one = tube.expose(buffer, (frames + 1) * frame, workers);
    const Image<LinearRgb>& next = tube.expose(buffer, (frames + 2) * frame, workers);
    const auto brightest = [](LinearRgb p) { return std::max({p.r, p.g, p.b}); };
    for (std::size_t i = 0; i < one.pixels().size(); ++i) {
      const double light = brightest(one.pixels()[i]);
      ASSERT_NEAR(light, 1, 3e-6 + late) << type.name;
      ASSERT_NEAR(brightest(next.pixels()[i]), light, 1e-6) << type.name;
    }
    EXPECT_LT(late, 1e-3) << type.name;
  }
}

TEST(RasterTube, ARadarsPictureTurnsFromBlueToYellowishGreenWhenTheBeamStops) {
  const VideoMode mode = tiny_mode();
  Workers workers(1);
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  fill(buffer, 0, kWhite);
  for (const char* phosphor : {"P7", "P7-long"}) {
    RasterTube tube = cell_tube(mode, phosphor);
    const LinearRgb lit = tube.expose(buffer, Seconds(1), workers).at(5, 5);
    EXPECT_GT(lit.b, 5 * std::abs(lit.g)) << phosphor;
    tube.expose(black, Seconds(1.15), workers);
    const LinearRgb faded = tube.expose(black, Seconds(1.2), workers).at(5, 5);
    EXPECT_GT(faded.g, 0) << phosphor;
    EXPECT_GT(faded.g, 2 * std::abs(faded.b)) << phosphor;
    EXPECT_GT(faded.g, faded.r) << phosphor;
    EXPECT_LT(faded.g, 1e-4f * lit.b) << phosphor;
  }
}

TEST(RasterTube, LongAndShortExposuresAreTaken) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube = cell_tube(mode, "P31");
  Workers workers(1);
  LightSum long_one, short_one, empty;
  long_one.add(tube.expose(buffer, Seconds(10), workers));
  EXPECT_NEAR(long_one.values()[1], 600, 1);  // 600 frames of white, less what still glows
  short_one.add(tube.expose(buffer, Seconds(10) + microseconds(1), workers));
  EXPECT_GT(short_one.values()[1], 0);
  EXPECT_LT(short_one.values()[1], 1e-2);
  empty.add(tube.expose(buffer, Seconds(10) + microseconds(1), workers));
  EXPECT_EQ(empty.mean(), 0);
}

TEST(RasterTube, AnExposureWithinALineLightsOnlyTheBeamsPath) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube = cell_tube(mode, "P31");
  Workers workers(1);
  // The beam is let in when it is at column 3 of line 5: nothing has been written before.
  FrameBuffer black = buffer_for(mode);
  const double line = 5 * 20;
  tube.expose(black, at_clock(mode, line + 3), workers);
  const Image<LinearRgb>& picture = tube.expose(buffer, at_clock(mode, line + 7.5), workers);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) {
      const bool passed = y == 5 && x >= 3 && x <= 7;
      EXPECT_EQ(picture.at(x, y).g > 0, passed) << x << "," << y;
    }
  }
  // The first pixel written has shone longest; the last one was on for half its dwell.
  EXPECT_GT(picture.at(3, 5).g, picture.at(6, 5).g);
  EXPECT_GT(picture.at(6, 5).g, picture.at(7, 5).g);

  const float tail_before = picture.at(3, 5).g;
  const Image<LinearRgb>& next = tube.expose(buffer, at_clock(mode, line + 9), workers);
  EXPECT_GT(next.at(3, 5).g, 0);  // its tail
  EXPECT_LT(next.at(3, 5).g, tail_before);
  EXPECT_GT(next.at(8, 5).g, 0);
  EXPECT_EQ(next.at(9, 5).g, 0);
  EXPECT_EQ(next.at(3, 6).g, 0);
}

TEST(RasterTube, FieldsOfInterlaceLightEverySecondLine) {
  const VideoMode mode = tiny_mode(true);
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube = cell_tube(mode, "P4");
  Workers workers(1);
  const Image<LinearRgb>& first = tube.expose(buffer, mode.field_period(), workers);
  for (int y = 0; y < 8; ++y) EXPECT_EQ(first.at(6, y).b > 0.5f, y % 2 == 0) << y;
  const Image<LinearRgb>& second = tube.expose(buffer, mode.frame_period(), workers);
  for (int y = 0; y < 8; ++y) EXPECT_EQ(second.at(6, y).b > 0.5f, y % 2 == 1) << y;
}

TEST(RasterTube, PagesFlipAtRetraceAndTearWhenForced) {
  const VideoMode mode = tiny_mode();
  Workers workers(1);
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 1, kWhite);
  RasterTube tube = cell_tube(mode, "P4");
  buffer.flip_at_retrace(1);
  LightSum dark;
  dark.add(tube.expose(buffer, mode.frame_period(), workers));
  EXPECT_EQ(dark.mean(), 0);
  EXPECT_EQ(buffer.visible_page(), 1);
  LightSum bright;
  bright.add(tube.expose(buffer, 2 * mode.frame_period(), workers));
  EXPECT_GT(bright.mean(), 0.5);

  tube.reset();
  buffer.flip_now(0);
  tube.expose(buffer, at_clock(mode, 4 * 20), workers);
  buffer.flip_now(1);
  const Image<LinearRgb>& torn = tube.expose(buffer, mode.frame_period(), workers);
  for (int y = 0; y < 8; ++y) EXPECT_EQ(torn.at(6, y).b > 0, y >= 4) << y;
}

TEST(RasterTube, TheTableChangesUnderTheBeam) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer(12, 8, PixelFormat::kIndexed8);
  buffer.set_colour(0, {255, 0, 0});
  buffer.set_colour_at_line(3, 0, {0, 0, 255});
  RasterTube tube = cell_tube(mode, "P22");
  Workers workers(1);
  const Image<LinearRgb>& picture = tube.expose(buffer, mode.frame_period(), workers);
  for (int y = 0; y < 8; ++y) {
    EXPECT_EQ(picture.at(5, y).r > picture.at(5, y).b, y < 3) << y;
    EXPECT_EQ(picture.at(5, y).b > picture.at(5, y).r, y >= 3) << y;
  }
}

TEST(RasterTube, ABufferSmallerThanTheModeLeavesTheRestDark) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer(5, 3, PixelFormat::kXrgb8888);
  fill(buffer, 0, kWhite);
  RasterTube tube = cell_tube(mode, "P4");
  Workers workers(1);
  const Image<LinearRgb>& picture = tube.expose(buffer, mode.frame_period(), workers);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) EXPECT_EQ(picture.at(x, y).b > 0, x < 5 && y < 3);
  }
}

TEST(RasterTube, GreysFollowTheGunsGamma) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, 0x808080);
  Workers workers(1);
  for (const char* phosphor : {"P22", "P4"}) {
    RasterTube tube = cell_tube(mode, phosphor);
    tube.expose(buffer, 30 * mode.frame_period(), workers);
    const LinearRgb p = tube.expose(buffer, 31 * mode.frame_period(), workers).at(6, 4);
    EXPECT_NEAR(std::max({p.r, p.g, p.b}), std::pow(128 / 255.0, 2.35), 1e-5) << phosphor;
  }
}

TEST(RasterTube, PicturesDoNotDependOnThreads) {
  const VideoMode mode = parse_mode("240p");
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 3);
  std::vector<Image<LinearRgb>> pictures;
  for (const int threads : {1, 2, 5}) {
    RasterTube tube({mode}, 400, 300);
    Workers workers(threads);
    tube.expose(buffer, milliseconds(21), workers);
    pictures.push_back(tube.expose(buffer, milliseconds(37.7), workers));
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

TEST(RasterTube, PicturesAgreeOnEveryInstructionSet) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 3);
  std::vector<LightSum> sums;
  const std::string chosen = simd_target();
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    RasterTube tube({mode}, 31, 29);
    Workers workers(1);
    tube.expose(buffer, milliseconds(21), workers);
    sums.emplace_back().add(tube.expose(buffer, milliseconds(30), workers));
    expect_equal_light(sums[0], sums.back(), 1e-5, target);
  }
  use_simd_target("best");
  EXPECT_EQ(simd_target(), chosen);
}

TEST(RasterTube, CopiesRepeatWhatTheOriginalDoes) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 3);
  RasterTube tube({mode, "P1"}, 20, 20);
  Workers workers(1);
  tube.expose(buffer, milliseconds(25), workers);
  RasterTube copy = tube;
  const Image<LinearRgb> a = tube.expose(buffer, milliseconds(30), workers);
  EXPECT_EQ(copy.now(), Seconds(330 / mode.pixel_clock_hz));
  EXPECT_EQ(copy.expose(buffer, milliseconds(30), workers), a);
  RasterTube other({mode, "P1"}, 3, 3);
  other = tube;
  tube.reset();
  EXPECT_EQ(tube.now(), Seconds(0));
  const Image<LinearRgb> b = other.expose(buffer, milliseconds(40), workers);
  EXPECT_EQ(copy.expose(buffer, milliseconds(40), workers), b);
  RasterTube fresh({mode, "P1"}, 20, 20);
  const Image<LinearRgb> first = fresh.expose(buffer, milliseconds(9), workers);
  EXPECT_EQ(tube.expose(buffer, milliseconds(9), workers), first);
}

TEST(RasterTube, ResizingKeepsTheGlow) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube({mode, "P1"}, 20, 20);
  Workers workers(1);
  tube.expose(buffer, 20 * mode.frame_period(), workers);
  RasterTube same = tube;
  tube.resize(40, 30);
  LightSum large, small;
  const Image<LinearRgb>& picture = tube.expose(black, 21 * mode.frame_period(), workers);
  EXPECT_EQ(picture.width(), 40);
  EXPECT_EQ(picture.height(), 30);
  large.add(picture);
  small.add(same.expose(black, 21 * mode.frame_period(), workers));
  EXPECT_NEAR(large.mean(), small.mean(), 1e-4 * small.mean());
}

TEST(RasterTube, APhotographAtOne4000thShowsAboutFourLines) {
  // display-facts: at 1/4000 s about 3.9 lines of a 15.7 kHz set are lit.
  const VideoMode mode = parse_mode("240p");
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube tube({mode, "P4"}, 320, 240);
  Workers workers(1);
  tube.expose(black, milliseconds(6), workers);
  const Image<LinearRgb>& photograph =
      tube.expose(buffer, milliseconds(6) + Seconds(1.0 / 4000), workers);
  double lines = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) lines += photograph.at(x, y).b > 0.05f ? 1.0 / 320 : 0;
  }
  EXPECT_NEAR(lines, 3.9, 0.9);
}

TEST(RasterTube, AStillPictureIsDrawnOnceAndStaysExact) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 4);
  RasterTube tube({mode}, 20, 20);
  Workers workers(2);
  Image<Srgb8> out(20, 20), again(20, 20);
  int drawn = 0, frame = 1;
  for (; frame <= 60; ++frame) {
    drawn += tube.photograph(buffer, frame * mode.frame_period(), workers, {out, 1, 0, 0, true});
  }
  EXPECT_LT(drawn, 40);
  EXPECT_GT(drawn, 2);
  EXPECT_FALSE(
      tube.photograph(buffer, frame++ * mode.frame_period(), workers, {out, 1, 0, 0, true}));
  // Elsewhere, or no longer kept, it is drawn again, and alike.
  EXPECT_TRUE(tube.photograph(buffer, frame++ * mode.frame_period(), workers, {again}));
  EXPECT_EQ(again, out);
  // So it is by another gain, and when that is taken back.
  EXPECT_TRUE(
      tube.photograph(buffer, frame++ * mode.frame_period(), workers, {out, 0.5f, 0, 0, true}));
  EXPECT_NE(again, out);
  EXPECT_TRUE(
      tube.photograph(buffer, frame++ * mode.frame_period(), workers, {out, 1, 0, 0, true}));
  EXPECT_EQ(again, out);
  // A change shows at once; and what was skipped is missed by no later exposure.
  RasterTube other({mode}, 20, 20);
  for (int i = 1; i < frame; ++i) other.expose(buffer, i * mode.frame_period(), workers);
  buffer.set_pixel(0, 5, 5, 0xffffff);
  const Image<LinearRgb> want = other.expose(buffer, (frame + 0.3) * mode.frame_period(), workers);
  const Image<LinearRgb>& got = tube.expose(buffer, (frame + 0.3) * mode.frame_period(), workers);
  for (std::size_t i = 0; i < want.pixels().size(); ++i) {
    ASSERT_NEAR(got.pixels()[i].g, want.pixels()[i].g, 3e-5) << i;
  }
}

TEST(RasterTube, TheRoomsLightComesInAsLongAsTheShutterIsOpen) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  TubeSettings settings{mode};
  settings.glass.ambient = 0.02;
  RasterTube tube(settings, 20, 20);
  Workers workers(1);
  EXPECT_NEAR(tube.expose(buffer, mode.frame_period(), workers).at(3, 3).g, 0.02, 1e-6);
  EXPECT_NEAR(tube.expose(buffer, 1.25 * mode.frame_period(), workers).at(3, 3).g, 0.005, 1e-6);
  EXPECT_NEAR(tube.expose(buffer, 4.25 * mode.frame_period(), workers).at(3, 3).g, 0.06, 1e-6);
}

TEST(RasterTube, RefusesWhatIsNoTube) {
  EXPECT_THROW(RasterTube({tiny_mode(), "P99"}, 8, 8), Error);
  VideoMode broken = tiny_mode();
  broken.horizontal.sync = 0;
  EXPECT_THROW(RasterTube({broken}, 8, 8), Error);
}

}  // namespace
}  // namespace kinescope
