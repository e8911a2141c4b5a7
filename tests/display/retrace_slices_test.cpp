// The light of the beam that flies back, in windows that cut through its flights, against a beam
// stepped along them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "display/phosphor.h"
#include "display/tube/gun.h"
#include "display/tube/spot.h"
#include "tests/display/small_tube.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

constexpr int kWidth = 80, kHeight = 60;
constexpr int kSteps = 4;  // a clock

/// Half of each line, and a third of all lines, are blanked.
VideoMode long_blanked_mode() {
  VideoMode mode;
  mode.name = "long-blanked";
  mode.horizontal = {40, 4, 40, 40};
  mode.vertical = {24, 2, 4, 6};
  mode.pixel_clock_hz = 124 * 36 * 60;
  return mode;
}

/// A dark raster whose blanked beam is lit.
TubeSettings lit_retrace(const VideoMode& mode, const std::string& phosphor) {
  TubeSettings settings{mode, phosphor};
  settings.spot.sigma_mm = 6;
  settings.gun.blanking = -0.3;
  return settings;
}

/// What a flash that comes back every frame gives in [begin, end), seconds, of a steady state.
double light_of_flash(const Phosphor& law, double flash, double begin, double end, double frame) {
  double light = 0;
  // Whole frames before the window's end, the window's own ones apart.
  const double last = flash + frame * std::floor((end - flash) / frame);
  for (double at = last; at >= begin; at -= frame) {
    for (const DecayTerm& term : law.terms) {
      light += term.share * -std::expm1(-(end - at) / term.tau.count());
    }
  }
  const double before = flash + frame * (std::ceil((begin - flash) / frame) - 1);
  for (const DecayTerm& term : law.terms) {
    const double tau = term.tau.count();
    light += term.share * std::exp(-(begin - before) / tau) * -std::expm1(-(end - begin) / tau) /
             -std::expm1(-frame / tau);
  }
  return light;
}

/// Every step of the blanked beam through a frame, a Gaussian where it then is.
std::vector<double> stepped_light(const TubeSettings& settings, double begin_s, double end_s) {
  const RasterScan scan(settings.mode);
  const SpotModel spot(settings.spot);
  const Gun gun(settings.gun, spot, settings.mode.pixel_clock_hz);
  const double current = gun.blanked_current(false);
  const double pixels_a_mm = kHeight / (settings.glass.diagonal_mm * 0.6);
  const double scale = 1 / (spot.sigma_mm(current) * pixels_a_mm * std::numbers::sqrt2);
  const Phosphor& law = find_phosphor(settings.phosphor).layers.front();
  const int clocks = settings.mode.horizontal.total() * settings.mode.vertical.total();
  const double cell_pixels = static_cast<double>(kWidth * kHeight) /
                             (settings.mode.horizontal.active * settings.mode.vertical.active);
  const auto share = [&](double at) {
    return 0.5 * (std::erf((at + 0.5) * scale) - std::erf((at - 0.5) * scale));
  };
  std::vector<double> light(kWidth * kHeight);
  for (int step = 0; step < clocks * kSteps; ++step) {
    const double flash = (step + 0.5) / kSteps / settings.mode.pixel_clock_hz;
    const BeamPosition beam = scan.at(Seconds(flash));
    if (!beam.blanked) continue;
    const double dose =
        current * cell_pixels / kSteps *
        light_of_flash(law, flash, begin_s, end_s, settings.mode.frame_period().count());
    const double px = beam.x * kWidth - 0.5, py = beam.y * kHeight - 0.5;
    const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
    for (int y = std::max(0, y0 - 9); y < std::min(kHeight, y0 + 10); ++y) {
      const double down = dose * share(y - py);
      for (int x = std::max(0, x0 - 9); x < std::min(kWidth, x0 + 10); ++x) {
        light[static_cast<std::size_t>(y * kWidth + x)] += down * share(x - px);
      }
    }
  }
  return light;
}

/// Windows by their lengths in clocks: parts of flights back and up, cut within a clock too.
constexpr double kCuts[] = {20 * 124 + 70, 9.4, 30.3, 4.3, 1, 11.25, 36 * 124 - 40};

class RetraceSlices : public testing::TestWithParam<std::pair<const char*, bool>> {};

TEST_P(RetraceSlices, ShowPartsOfFlightsAsABeamStepsAlongThem) {
  const auto [phosphor, free] = GetParam();
  const VideoMode mode = long_blanked_mode();
  TubeSettings settings = lit_retrace(mode, phosphor);
  FrameBuffer buffer = buffer_for(mode);
  Workers workers(2);
  TubeSettings tube = settings;
  if (free) tube.sweep.hum_x = 1e-9;
  RasterTube seen(tube, kWidth, kHeight);
  double end = 30 * mode.horizontal.total() * mode.vertical.total();
  seen.expose(buffer, at_clock(mode, end), workers);
  for (const double length : kCuts) {
    const double begin = end;
    end += length;
    const Image<LinearRgb>& picture = seen.expose(buffer, at_clock(mode, end), workers);
    const std::vector<double> want =
        stepped_light(settings, at_clock(mode, begin).count(), at_clock(mode, end).count());
    const double brightest = *std::max_element(want.begin(), want.end());
    double off = 0, sum = 0, wanted = 0;
    for (std::size_t i = 0; i < want.size(); ++i) {
      const double got = static_cast<double>(picture.pixels()[i].g);
      off = std::max(off, std::abs(got - want[i]));
      sum += got;
      wanted += want[i];
    }
    EXPECT_LT(off, 0.01 * brightest) << length;
    EXPECT_NEAR(sum, wanted, 1e-3 * wanted) << length;
  }
}

TEST_P(RetraceSlices, AddUpToTheWhole) {
  const auto [phosphor, free] = GetParam();
  const VideoMode mode = long_blanked_mode();
  TubeSettings settings = lit_retrace(mode, phosphor);
  if (free) settings.sweep.hum_x = 0.05;
  FrameBuffer buffer = buffer_for(mode);
  Workers workers(2);
  RasterTube whole(settings, kWidth, kHeight);
  const double frame = mode.horizontal.total() * mode.vertical.total();
  const double begin = 2.3 * frame, end = 3.6 * frame;
  whole.expose(buffer, at_clock(mode, begin), workers);
  RasterTube sliced = whole;
  LightSum one, many;
  one.add(whole.expose(buffer, at_clock(mode, end), workers));
  constexpr int kSlices = kSanitized ? 40 : 300;
  for (int i = 1; i <= kSlices; ++i) {
    many.add(sliced.expose(buffer, at_clock(mode, begin + (end - begin) * i / kSlices), workers));
  }
  expect_equal_light(one, many, 1e-5, phosphor);
}

INSTANTIATE_TEST_SUITE_P(RetraceLight, RetraceSlices,
                         testing::Values(std::pair{"P31", false}, std::pair{"P1", false},
                                         std::pair{"P31", true}, std::pair{"P1", true}));

}  // namespace
}  // namespace kinescope
