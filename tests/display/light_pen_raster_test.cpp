// The light pen before masks, and on rasters that run free.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "display/pen_mask.h"
#include "tests/display/light_pen_testing.h"

namespace kinescope {
namespace {

/// Whether a gun's openings let light through there, mm from the glass's middle.
bool is_open(const MaskSettings& mask, int gun, double x, double y) {
  const auto off = [](double v, double period) { return v - std::round(v / period) * period; };
  const double pitch = mask.pitch_mm, third = pitch / 3;
  if (mask.kind == MaskKind::kGrille) {
    return std::abs(off(x - (gun - 1) * third, pitch)) < mask.open * third / 2;
  }
  for (const double half : {0.0, 0.5}) {
    const double dx = off(x - (gun - 1) * third - 2 * half * pitch, 2 * pitch);
    const double dy = off(y - half * mask.slot_mm, mask.slot_mm);
    if (std::abs(dx) < mask.open * third / 2 && std::abs(dy) < (1 - mask.bridge) * mask.slot_mm / 2)
      return true;
  }
  return false;
}

TEST(LightPen, SeesThroughAMaskWhatItsOpeningsLetThrough) {
  SpotSettings spot;
  spot.sigma_mm = 0.2;
  const SpotModel model(spot);
  const SpotInView in_view(model, 0.8);
  const double view = 0.8 / std::sqrt(8 * std::log(2.0));
  for (const MaskKind kind : {MaskKind::kGrille, MaskKind::kSlots}) {
    const MaskSettings mask{kind, 0.6, 0.8, 0.7, 0.2};
    const PenMask pen(mask, {in_view.seen(0, 0, 0).sigma_mm, in_view.seen(1, 0, 0).sigma_mm});
    for (const Place at : {Place{0, 0}, {0.31, -0.1}, {-0.2, 0.35}}) {  // from an axis at (1, 2)
      const SpotInView::Seen seen = in_view.seen(1, at.x, at.y);
      for (const int gun : {0, 2}) {
        const double across = model.wide_mm() * model.astigmatism(), down = model.wide_mm();
        double all = 0, through = 0;
        for (double x = -1.2; x < 1.2; x += 0.008) {
          for (double y = -1.2; y < 1.2; y += 0.008) {
            const double dx = (x - at.x) / across, dy = (y - at.y) / down;
            const double light =
                std::exp(-0.5 * ((x * x + y * y) / (view * view) + dx * dx + dy * dy));
            all += light;
            if (is_open(mask, gun, 1 + x, 2 + y)) through += light;
          }
        }
        const double slots = kind == MaskKind::kGrille ? 1 : 1 - mask.bridge;
        const double open = mask.open / 3 * slots;  // its mean
        EXPECT_NEAR(pen.share(gun, 1, {1 + seen.middle_mm.x, 2 + seen.middle_mm.y}),
                    through / all / open, 0.03);
      }
    }
  }
}

TEST(LightPen, TellsThePixelBelowItBeforeAMask) {
  for (const MaskKind kind : {MaskKind::kDots, MaskKind::kGrille, MaskKind::kSlots}) {
    TubeSettings tube{parse_mode("640x480@60")};
    tube.spot.sigma_mm = 0.2;
    tube.mask = {kind, 0.6, 0.8, 0.8};
    const FrameBuffer buffer = plain(tube.mode, kWhite);
    LightPenSettings settings = narrow_pen(tube);
    settings.threshold = 0.2;
    LightPen pen(tube, settings);
    double least = 9, most = 0;
    for (int i = 0; i < 7; ++i) {
      pen.move(middle_of(tube.mode, 300 + i, 200 + i));
      const auto tripped = pen.watch(buffer, frame_of(tube.mode, 1));
      ASSERT_TRUE(tripped);
      // The openings' light comes a little before or after the axis's.
      EXPECT_NEAR(pen.address(*tripped).line, 200 + i, 1);
      EXPECT_NEAR(pen.address(*tripped).pixel, 300 + i, 3);
      double peak = 0;
      for (const LightPen::Sample& s : pen.record(buffer, frame_of(tube.mode, 1))) {
        peak = std::max(peak, s.signal);
      }
      least = std::min(least, peak);
      most = std::max(most, peak);
    }
    EXPECT_GT(most, 1.05 * least);  // the mask is seen
  }
}

TEST(LightPen, OnARollingRasterTellsWhatTheVideoSentWhenLightCame) {
  const VideoMode mode = small_mode();
  TubeSettings tube = fading(mode);
  tube.deflection.rotation_deg = 0;
  tube.sweep.field_hz = 57.3;
  tube.sweep.line_hz = 0.99 * mode.line_rate_hz();
  tube.sweep.hum_x = 0.05;
  LightPenSettings settings;
  settings.place = middle_of(mode, 20, 30);
  settings.view_mm = 5;
  settings.rise = at_clock(mode, 0.3);
  settings.coupling = at_clock(mode, 20);
  settings.threshold = 0.3;
  const LightPen pen(tube, settings);
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  Workers workers(1);
  RasterTube seen(tube, 64, 48);
  int last_line = -1, told = 0;
  for (const double field : {3, 4, 5, 9}) {
    const Exposure sweep{Seconds(field / 57.3), Seconds((field + 1) / 57.3)};
    const auto tripped = pen.watch(buffer, sweep);
    if (!tripped) continue;  // video's blanking lay there
    ++told;
    // Nothing has come to the pen's place in this sweep until a line before, and then it does.
    const Seconds line = at_clock(mode, 80);
    seen.expose(buffer, *tripped - 3 * line, workers);
    const float before = seen.expose(buffer, *tripped - 2 * line, workers).at(20, 30).g;
    const float then = seen.expose(buffer, *tripped + line, workers).at(20, 30).g;
    EXPECT_LT(before, 0.05f * then) << field;
    // The address is that of the clock at which the video sent it.
    const double clock = (*tripped - pen.delay()).count() * mode.pixel_clock_hz;
    const PixelAddress address = pen.address(*tripped);
    EXPECT_EQ(address.line, static_cast<int>(clock / 80) % 60);
    EXPECT_NEAR(address.pixel, std::fmod(clock, 80), 1.01);
    // A sweep is 62.8 lines of video: what lies below the pen has moved on.
    if (field == 4 && last_line >= 0) {
      EXPECT_NEAR(address.line - last_line, 62.8 - 60, 1.5);
    }
    last_line = address.line;
  }
  EXPECT_GE(told, 3);
}

TEST(LightPen, FollowsOscillatorsWhoseKnobsWereTurned) {
  const VideoMode mode = small_mode();
  TubeSettings tube = fading(mode);
  tube.sweep.field_hz = 50;
  const FreeSweep first(tube.sweep, mode);
  tube.sweep.field_hz = 55;
  FreeSweep turned(tube.sweep, mode);
  turned.take_over(first, clocks(11111));
  LightPenSettings settings;
  settings.view_mm = 5;
  LightPen pen(tube, settings);
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  const Exposure window{Seconds(0.1), Seconds(0.2)};
  const auto alone = pen.watch(buffer, window);
  pen.follow(turned);
  const auto followed = pen.watch(buffer, window);
  ASSERT_TRUE(alone && followed);
  const double turn = 1.0 / 55;
  const auto phase = [&](Seconds t, BeamTime began) {
    return std::fmod(t.count() - to_clocks(began) / mode.pixel_clock_hz + 50 * turn, turn);
  };
  EXPECT_NEAR(phase(*alone, FreeSweep(tube.sweep, mode).field(0).begin),
              phase(*followed, turned.field(0).begin), 3e-4);  // a line
  EXPECT_GT(std::abs(alone->count() - followed->count()), 1e-3);
}

}  // namespace
}  // namespace kinescope
