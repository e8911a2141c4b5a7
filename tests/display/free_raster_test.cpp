// Sweeps that land elsewhere than the last one did: lost sync, hum, sag, fields that pair; and what
// they leave behind on the glass.
#include "display/tube/free_raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "display/raster_tube.h"
#include "tests/display/tube_fixtures.h"

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

double largest(const Image<LinearRgb>& picture) {
  double most = 0;
  for (const LinearRgb& p : picture.pixels()) {
    for (const float v : {p.r, p.g, p.b}) most = std::max(most, std::abs(static_cast<double>(v)));
  }
  return most;
}

double largest_difference(const Image<LinearRgb>& a, const Image<LinearRgb>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const LinearRgb p = a.pixels()[i], q = b.pixels()[i];
    for (const float d : {p.r - q.r, p.g - q.g, p.b - q.b}) {
      most = std::max(most, std::abs(static_cast<double>(d)));
    }
  }
  return most;
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
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 11);
  Workers workers(2);
  RasterTube whole(settings, kWidth, kHeight);
  const double begin = 310, end = 1210.25;
  whole.expose(buffer, at_clock(mode, begin), workers);
  RasterTube sliced = whole;
  LightSum one, many;
  one.add(whole.expose(buffer, at_clock(mode, end), workers));
  for (int i = 1; i <= 90; ++i) {
    many.add(sliced.expose(buffer, at_clock(mode, begin + (end - begin) * i / 90), workers));
  }
  for (std::size_t i = 0; i < one.values().size(); ++i) {
    EXPECT_NEAR(one.values()[i], many.values()[i], 2e-5) << i;
  }
}

}  // namespace
}  // namespace kinescope
