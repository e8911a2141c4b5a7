// The light pen against exposures of the tube itself, and against the scan.
#include "display/light_pen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/display/light_pen_testing.h"

namespace kinescope {
namespace {

/// What a pen would make of the tube's own pictures, taken slice after slice: its view a Gaussian
/// laid over each, its two filters stepped.
class SlicedPen {
 public:
  SlicedPen(const TubeSettings& tube, const LightPenSettings& pen, int width, int height)
      : pen_(pen), tube_(tube, width, height), clock_hz_(tube.mode.pixel_clock_hz) {
    const PixelsAMm scale = pixels_a_mm(tube.glass, width, height);
    const double sigma = pen.view_mm / std::sqrt(8 * std::log(2.0));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double dx = (x + 0.5 - 0.5 * width * (1 + pen.place.x)) / scale.across;
        const double dy = (y + 0.5 - 0.5 * height * (1 + pen.place.y)) / scale.down;
        weights_.push_back(std::exp(-0.5 * (dx * dx + dy * dy) / (sigma * sigma)));
      }
    }
  }
  /// The signal after another slice, in units of its own.
  double next(FrameBuffer& buffer, double clocks, Workers& workers) {
    now_ += clocks;
    const Image<LinearRgb>& light = tube_.expose(buffer, Seconds(now_ / clock_hz_), workers);
    double sum = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const LinearRgb c = light.pixels()[i];
      sum += weights_[i] * static_cast<double>(c.r + c.g + c.b);
    }
    const double rate = sum / clocks;
    // Low-passes that meet a light steady over the slice.
    const auto follow = [&](double& state, double to, Seconds tau) {
      state += (to - state) * -std::expm1(-clocks / (tau.count() * clock_hz_));
    };
    follow(lagged_, rate, pen_.rise);
    follow(held_, lagged_, pen_.coupling);
    return lagged_ - held_;
  }
  double now() const { return now_; }

 private:
  LightPenSettings pen_;
  RasterTube tube_;
  double clock_hz_;
  std::vector<double> weights_;
  double now_ = 0, lagged_ = 0, held_ = 0;
};

/// The signal at a clock, between samples.
double signal_at(const std::vector<LightPen::Sample>& samples, const VideoMode& mode,
                 double clock) {
  const Seconds time = at_clock(mode, clock);
  std::size_t i = 1;
  while (i + 1 < samples.size() && samples[i].time < time) ++i;
  const LightPen::Sample &a = samples[i - 1], &b = samples[i];
  return a.signal + (b.signal - a.signal) * ((time - a.time) / (b.time - a.time));
}

// The tube lights a cell all at once; before the pen the beam crosses it.
constexpr double kApart = 0.035;

void expect_the_tubes_light(const std::string& phosphor) {
  TubeSettings tube{tiny_mode(), phosphor};
  tube.glass.diagonal_mm = 20;
  tube.spot.sigma_mm = 0.35;
  LightPenSettings settings;
  settings.place = middle_of(tube.mode, 7, 4);
  settings.view_mm = 2.4;
  settings.rise = at_clock(tube.mode, 0.6);
  settings.coupling = at_clock(tube.mode, 6);
  FrameBuffer buffer = buffer_for(tube.mode);
  fill_random(buffer, 0, 3);
  const LightPen pen(tube, settings);
  const auto samples = pen.record(buffer, frame_of(tube.mode, 1));
  ASSERT_GT(samples.size(), 100u);
  SlicedPen sliced(tube, settings, 120, 90);
  Workers workers(1);
  constexpr double kSlice = 1.0 / 32;
  const double frame = tube.mode.horizontal.total() * tube.mode.vertical.total();
  double scale = 0, ours = 0;
  std::vector<std::pair<double, double>> pairs;
  sliced.next(buffer, frame, workers);
  while (sliced.now() < frame + 7 * tube.mode.horizontal.total()) {
    const double signal = sliced.next(buffer, kSlice, workers);
    const double seen = signal_at(samples, tube.mode, sliced.now());
    // Only where the pen has samples, and when the slice of a whole frame is forgotten.
    const double steps = 4 * sliced.now();
    if (sliced.now() < frame + 10 || steps != std::floor(steps)) continue;
    pairs.emplace_back(signal, seen);
    scale += signal * seen;
    ours += seen * seen;
  }
  double peak = 0, worst = 0;
  for (const auto& [signal, seen] : pairs) {
    peak = std::max(peak, std::abs(seen));
    worst = std::max(worst, std::abs(signal / (scale / ours) - seen));
  }
  EXPECT_GT(peak, 0.1) << phosphor;
  EXPECT_LT(worst, kApart * peak) << phosphor;
}

TEST(LightPen, SeesTheLightThatExposuresOfTheTubeShow) {
  for (const char* phosphor : {"P4", "P31", "P11", "P1"}) expect_the_tubes_light(phosphor);
}

TEST(LightPen, TellsThePixelBelowIt) {
  for (const char* name : {"640x480@60", "240p", "ntsc", "1024x768@75", "1600x1200@60"}) {
    TubeSettings tube{parse_mode(name)};
    tube.spot.sigma_mm = 0.08;
    const VideoMode& mode = tube.mode;
    const int right = mode.horizontal.active - 1, bottom = mode.vertical.active - 1;
    const FrameBuffer buffer = plain(mode, kWhite);
    LightPen pen(tube, narrow_pen(tube));
    for (const auto& [pixel, line] : {std::pair{0, 0},
                                      {right, 0},
                                      {0, bottom},
                                      {right, bottom},
                                      {right / 2, bottom / 2},
                                      {3, bottom - 1},
                                      {right - 5, bottom / 3}}) {
      pen.move(middle_of(mode, pixel, line));
      const auto tripped = pen.watch(buffer, frame_of(mode, 3));
      ASSERT_TRUE(tripped) << name << " " << pixel << "," << line;
      const PixelAddress address = pen.address(*tripped);
      EXPECT_EQ(address.line, line) << name << " " << pixel;
      // At the left margin light comes late, for half of what leads up to it is missing.
      EXPECT_NEAR(address.pixel, pixel, pixel == 0 ? 2 : 0) << name << " " << line;
      EXPECT_EQ(address.frame, 3);
    }
  }
}

TEST(LightPen, FollowsTheDeflection) {
  TubeSettings tube{parse_mode("640x480@60")};
  tube.spot.sigma_mm = 0.08;
  tube.glass.curvature_mm = 600;
  tube.deflection = {0.9, 0.8, 0.03, -0.05, 0.04, 0.03, 0.02, 1.5, 0.03, {}};
  const FrameBuffer buffer = plain(tube.mode, kWhite);
  LightPen pen(tube, narrow_pen(tube));
  const Deflection deflection(tube.deflection, tube.glass, 0);
  for (const auto& [pixel, line] : {std::pair{40, 30}, {600, 50}, {320, 240}, {90, 440}}) {
    pen.move(deflection.glass_of_sweep(middle_of(tube.mode, pixel, line)));
    const auto tripped = pen.watch(buffer, frame_of(tube.mode, 0));
    ASSERT_TRUE(tripped);
    EXPECT_EQ(pen.address(*tripped).line, line);
    EXPECT_NEAR(pen.address(*tripped).pixel, pixel, 1);
  }
}

TEST(LightPen, ItsDelayIsThatOfItsAmplifier) {
  TubeSettings tube{parse_mode("640x480@60"), "P1"};  // rises at once, stays for long
  LightPenSettings settings = narrow_pen(tube);
  settings.coupling = Seconds(20e-6);
  double last = -1;
  for (const double rise_ns : {10.0, 50.0, 200.0, 1000.0}) {
    settings.rise = Seconds(rise_ns * 1e-9);
    const LightPen pen(tube, settings);
    // A step through a low-pass of one pole reaches a share s after -ln(1 - s) of its constant,
    // but here of a peak that the coupling takes some of.
    const double lag_ns = -std::log(1 - settings.threshold) * rise_ns;
    EXPECT_NEAR(pen.delay().count() * 1e9, lag_ns, 0.15 * lag_ns + 15) << rise_ns;
    EXPECT_GT(pen.delay().count(), last);
    last = pen.delay().count();
  }
}

TEST(LightPen, SlowAmplifiersTellTheSamePixel) {
  TubeSettings tube{parse_mode("640x480@60")};
  tube.spot.sigma_mm = 0.08;
  const FrameBuffer buffer = plain(tube.mode, kWhite);
  for (const double rise_ns : {10.0, 100.0, 400.0}) {
    LightPenSettings settings = narrow_pen(tube);
    settings.rise = Seconds(rise_ns * 1e-9);
    settings.place = middle_of(tube.mode, 200, 300);
    const LightPen pen(tube, settings);
    const auto tripped = pen.watch(buffer, frame_of(tube.mode, 0));
    ASSERT_TRUE(tripped) << rise_ns;
    EXPECT_EQ(pen.address(*tripped), (PixelAddress{0, 300, 200})) << rise_ns;
  }
}

TEST(LightPen, SeesNothingInTheDarkNorBesideTheRaster) {
  const TubeSettings tube{parse_mode("640x480@60")};
  LightPen pen(tube, {});
  EXPECT_FALSE(pen.watch(plain(tube.mode, 0), frame_of(tube.mode, 0)));
  const FrameBuffer white = plain(tube.mode, kWhite);
  EXPECT_TRUE(pen.watch(white, frame_of(tube.mode, 0)));
  pen.move({1.3, 0});
  EXPECT_FALSE(pen.watch(white, frame_of(tube.mode, 0)));
  pen.move({0, -1.4});
  EXPECT_FALSE(pen.watch(white, frame_of(tube.mode, 0)));
}

TEST(LightPen, TripsOnlyBeyondItsThreshold) {
  const TubeSettings tube{parse_mode("640x480@60")};
  const Gun gun(tube.gun, SpotModel(tube.spot), tube.mode.pixel_clock_hz);
  for (const double threshold : {0.1, 0.4, 0.8}) {
    LightPenSettings settings = narrow_pen(tube);
    settings.threshold = threshold;
    settings.place = middle_of(tube.mode, 320, 240);
    const LightPen pen(tube, settings);
    // One line of grey: as light as its current, but for the spot that grows with it.
    int least = 256;
    for (int code = 255; code >= 0; --code) {
      FrameBuffer buffer = buffer_for(tube.mode, 1);
      const auto grey = static_cast<std::uint32_t>(code * 0x010101);
      for (int x = 0; x < 640; ++x) buffer.set_pixel(0, x, 240, grey);
      if (!pen.watch(buffer, frame_of(tube.mode, 0))) break;
      least = code;
    }
    EXPECT_NEAR(gun.current(least / 255.0), threshold, 0.08 * threshold) << threshold;
  }
}

TEST(LightPen, AWideViewTellsALineAbove) {
  const TubeSettings tube{parse_mode("640x480@60")};
  const FrameBuffer buffer = plain(tube.mode, kWhite);
  int last = 240;
  for (const double view_mm : {0.5, 3.0, 6.0, 12.0}) {
    LightPenSettings settings;
    settings.view_mm = view_mm;
    settings.place = middle_of(tube.mode, 320, 240);
    const LightPen pen(tube, settings);
    const auto tripped = pen.watch(buffer, frame_of(tube.mode, 0));
    ASSERT_TRUE(tripped);
    const PixelAddress address = pen.address(*tripped);
    EXPECT_LE(address.line, last) << view_mm;
    // Half as much light comes from half a view away, a little more than the threshold.
    EXPECT_NEAR((240 - address.line) * 198.0 / 480, 0.57 * view_mm, 0.6) << view_mm;
    last = address.line;
  }
}

TEST(LightPen, CutsOfAWindowTripWhereTheWholeDoes) {
  const TubeSettings tube{parse_mode("640x480@60")};
  const FrameBuffer buffer = plain(tube.mode, 0x808080);
  LightPenSettings settings;
  settings.threshold = 0.1;
  settings.place = {0.2, 0.3};
  const LightPen pen(tube, settings);
  const Exposure whole = frame_of(tube.mode, 2);
  const auto tripped = pen.watch(buffer, whole);
  ASSERT_TRUE(tripped);
  int cuts_tripped = 0;
  constexpr int kCuts = 50;
  for (int i = 0; i < kCuts; ++i) {
    const Seconds begin = whole.begin + whole.length() * (static_cast<double>(i) / kCuts);
    const Seconds end = whole.begin + whole.length() * ((i + 1.0) / kCuts);
    const auto cut = pen.watch(buffer, {begin, end});
    if (*tripped >= begin && *tripped < end) {
      ASSERT_TRUE(cut);
      EXPECT_NEAR(cut->count(), tripped->count(), 1e-12);
    }
    cuts_tripped += cut.has_value();
  }
  EXPECT_LE(cuts_tripped, 2);  // the lines in view pass within two cuts
  EXPECT_FALSE(pen.watch(buffer, {whole.begin, *tripped}));
}

}  // namespace
}  // namespace kinescope
