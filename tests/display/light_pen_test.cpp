// The light pen against exposures of the tube itself, and against the scan.
#include "display/light_pen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/display/small_tube.h"

namespace kinescope {
namespace {

/// A picture of one colour.
FrameBuffer plain(const VideoMode& mode, std::uint32_t colour) {
  FrameBuffer buffer = buffer_for(mode, 1);
  fill(buffer, 0, colour);
  return buffer;
}

/// The middle of a pixel of a raster that fills a flat glass.
Place middle_of(const VideoMode& mode, int pixel, int line) {
  return {2 * (pixel + 0.5) / mode.horizontal.active - 1,
          2 * (line + 0.5) / mode.vertical.active - 1};
}

Exposure frame_of(const VideoMode& mode, int number) {
  return {number * mode.frame_period(), (number + 1) * mode.frame_period()};
}

/// A pen whose view is about one line high.
LightPenSettings narrow_pen(const TubeSettings& tube) {
  const PixelsAMm lines = pixels_a_mm(tube.glass, 1, tube.mode.vertical.active);
  LightPenSettings pen;
  pen.view_mm = 0.9 / lines.down;
  return pen;
}

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
