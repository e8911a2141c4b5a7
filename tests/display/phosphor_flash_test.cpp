#include "display/phosphor_flash.h"

#include <gtest/gtest.h>

#include <cmath>

#include "display/layer_colours.h"

namespace kinescope {
namespace {

/// Light of each layer by small steps: a beam of even strength from `begin` to `end`, in layers
/// that hold light to come already.
struct SteppedSpot {
  const PhosphorType& type;
  double begin, end, strength;
  bool steady;

  LinearRgb light(double from, double to) const {
    const auto colours = layer_colours(type);
    const int steps = 200000;
    const double dt = to / steps;
    double sum[3] = {};
    for (std::size_t i = 0; i < type.layers.size(); ++i) {
      for (const DecayTerm& term : type.layers[i].terms) {
        const double tau = term.tau.count(), keep = std::exp(-dt / tau);
        double held = steady ? term.share * tau * strength : 0;
        for (int k = 0; k < steps; ++k) {
          const double t = (k + 0.5) * dt;
          const double dose = t > begin && t < end ? term.share * strength * dt : 0;
          const double out = held * (1 - keep) + dose * (1 - std::sqrt(keep));
          held += dose - out;
          if (t < from) continue;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += out * static_cast<double>(colours[i][c]);
        }
      }
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
  }
};

void expect_near(LinearRgb got, LinearRgb want) {
  const float scale = std::abs(want.r) + std::abs(want.g) + std::abs(want.b);
  EXPECT_NEAR(got.r, want.r, 2e-3f * scale);
  EXPECT_NEAR(got.g, want.g, 2e-3f * scale);
  EXPECT_NEAR(got.b, want.b, 2e-3f * scale);
}

TEST(FlashedSpot, AgreesWithSmallSteps) {
  for (const char* name : {"P31", "P7", "P22", "P1"}) {
    const PhosphorType& type = find_phosphor(name);
    const FlashedSpot pulse(type, {microseconds(100), false, 2});
    const SteppedSpot stepped{type, 0, 1e-4, 2 / 1e-4, false};
    for (const auto& [a, b] : {std::pair{0.0, 4e-5}, {3e-5, 3e-4}, {2e-4, 5e-4}}) {
      expect_near(pulse.light({Seconds(a), Seconds(b)}), stepped.light(a, b));
    }
    const FlashedSpot steady(type, {microseconds(50), true});
    const SteppedSpot lit{type, 0, 5e-5, 1, true};
    for (const auto& [a, b] : {std::pair{0.0, 4e-5}, {3e-5, 3e-4}, {2e-4, 5e-4}}) {
      expect_near(steady.light({Seconds(a), Seconds(b)}), lit.light(a, b));
    }
  }
}

TEST(FlashedSpot, BrightnessFallsFromOneAsTheLawSays) {
  const PhosphorType& type = find_phosphor("P31");
  const FlashedSpot steady(type, {Seconds(0), true});
  const FlashedSpot pulse(type, {microseconds(100)});
  EXPECT_DOUBLE_EQ(steady.brightness(Seconds(0)), 1);
  EXPECT_DOUBLE_EQ(pulse.brightness(Seconds(0)), 1);
  EXPECT_NEAR(steady.brightness(microseconds(340)), 0.1, 2e-3);
  // Short excitation leaves less for later.
  EXPECT_LT(pulse.brightness(microseconds(340)), 0.08);
  // Brightness is the rate of light.
  const Exposure early{microseconds(100), microseconds(100.1)};
  const Exposure late{microseconds(400), microseconds(400.1)};
  EXPECT_NEAR(pulse.light(late).g / pulse.light(early).g, pulse.brightness(microseconds(300.05)),
              2e-3);
}

TEST(FlashedSpot, HueIsTheLayersMixtureAsItFades) {
  const FlashedSpot radar(find_phosphor("P7-long"), {Seconds(0), true});
  const LinearRgb lit = radar.hue(Seconds(0)), faded = radar.hue(Seconds(1));
  EXPECT_EQ(lit.b, 1);
  EXPECT_EQ(faded.g, 1);
  EXPECT_LT(faded.b, 0.1f);
  EXPECT_GE(lit.g, 0);
  // What has gone dark has no hue.
  EXPECT_EQ(FlashedSpot(find_phosphor("P15"), {Seconds(0), true}).hue(Seconds(1)), LinearRgb{});
}

TEST(FlashedSpot, ExposuresAddUp) {
  const FlashedSpot spot(find_phosphor("P14"), {microseconds(0.04)});
  float sum = 0;
  for (int i = 0; i < 100; ++i)
    sum += spot.light({i * milliseconds(1), (i + 1) * milliseconds(1)}).r;
  EXPECT_NEAR(spot.light({Seconds(0), milliseconds(100)}).r, sum, 1e-5f);
}

}  // namespace
}  // namespace kinescope
