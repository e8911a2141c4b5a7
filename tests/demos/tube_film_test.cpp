#include "demos/tube_film.h"

#include <gtest/gtest.h>

#include "display/light_encode.h"
#include "display/tube/preset.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

TubeShot small_shot() {
  TubeShot shot;
  shot.tube = tube_presets().front().settings;
  shot.tube.mode = {"small", 360000, {64, 8, 12, 16}, {48, 2, 2, 8}, false};  // 60 Hz
  shot.size = {64, 48};
  shot.aspect = 4.0 / 3;
  shot.shutter = shot.tube.mode.frame_period();
  return shot;
}

/// A picture that is another in each refresh.
class TubeFilmTest : public ::testing::Test {
 protected:
  TubeCamera::Source source() {
    return [this](std::int64_t refresh) -> const Image<Srgb8>& {
      const auto code = static_cast<std::uint8_t>(refresh * 90 % 256);
      for (Srgb8& p : picture_.pixels()) {
        p = {code, 200, static_cast<std::uint8_t>(255 - code), 255};
      }
      return picture_;
    };
  }
  Image<Srgb8> picture_{64, 48};
  Workers workers_{2};
};

TEST_F(TubeFilmTest, PicturesThatShareLightAreEachWhole) {
  for (const double rate_hz : {61.0, 75.0, 120.0, 144.0, 400.0}) {
    TubeShot shot = small_shot();
    shot.every = Seconds(1 / rate_hz);
    TubeFilm film(shot, source(), workers_);
    for (int i = 0; i < 9; ++i) {
      const Exposure exposure{i * shot.every, i * shot.every + shot.shutter};
      TubeCamera alone(shot.tube, 64, 48, source(), workers_);
      Image<Srgb8> expected;
      encode_light(alone.expose(exposure), ExposureGain::average(exposure, shot.shutter), workers_,
                   expected);
      const auto seen = std::get<Image<Srgb8>>(film.shoot(exposure.begin));
      for (std::size_t k = 0; k < seen.pixels().size(); ++k) {
        ASSERT_NEAR(seen.pixels()[k].r, expected.pixels()[k].r, 1) << rate_hz << ' ' << i;
        ASSERT_NEAR(seen.pixels()[k].b, expected.pixels()[k].b, 1) << rate_hz << ' ' << i;
      }
    }
  }
}

TEST_F(TubeFilmTest, LiesOnBlackAndHasItsDepth) {
  TubeShot shot = small_shot();
  shot.size = {100, 48};
  shot.deep = true;
  TubeFilm film(shot, source(), workers_);
  const auto picture = std::get<Image<Srgb16>>(film.shoot(Seconds(0)));
  ASSERT_EQ(picture.width(), 100);
  EXPECT_EQ(picture.at(10, 20), Srgb16{});
  EXPECT_GT(picture.at(50, 20).g, 30000);
}

TEST(CheckShutter, ACamerasIsNoLongerThanAFrame) {
  EXPECT_NO_THROW(check_shutter(Seconds(1.0 / 60), Rate{60, 1}, true));
  EXPECT_THROW(check_shutter(Seconds(1.0 / 59), Rate{60, 1}, true), Error);
  EXPECT_NO_THROW(check_shutter(Seconds(1.0 / 59), Rate{60, 1}, false));
  EXPECT_NO_THROW(check_shutter(Seconds(1.0 / 60), Rate{480, 1}, false));
  EXPECT_THROW(check_shutter(Seconds(1.0 / 60), Rate{500, 1}, false), Error);
}

}  // namespace
}  // namespace kinescope
