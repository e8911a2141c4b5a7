// The photodiode's closed form against small steps.
#include "display/photodiode.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace kinescope {
namespace {

constexpr double kClockHz = 25e6;

/// Layers, filters and phosphor stepped by Heun's rule.
class SteppedDiode {
 public:
  SteppedDiode(std::span<const Phosphor> layers, Seconds rise, Seconds coupling)
      : rise_(rise.count() * kClockHz), coupling_(coupling.count() * kClockHz) {
    double all = 0;
    for (const Phosphor& layer : layers) all += layer.share;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
      for (const DecayTerm& t : layers[layer].terms) {
        terms_.push_back({layer, t.share * layers[layer].share / all, t.tau.count() * kClockHz, 0});
      }
    }
  }
  void pass(double clocks, std::span<const double> rates) {
    const int steps = static_cast<int>(std::ceil(clocks * 1000));
    for (int i = 0; i < steps; ++i) step(clocks / steps, rates);
  }
  double signal() const { return lagged_ - held_; }

 private:
  struct Term {
    std::size_t layer;
    double share, tau, light;
  };
  void step(double h, std::span<const double> rates) {
    double light = 0, light_after = 0;
    for (Term& t : terms_) {
      light += t.light;
      const double to = rates[t.layer] * t.share;
      t.light = to + (t.light - to) * std::exp(-h / t.tau);
      light_after += t.light;
    }
    const double slope = (light - lagged_) / rise_, held_slope = (lagged_ - held_) / coupling_;
    const double guess = lagged_ + h * slope, held_guess = held_ + h * held_slope;
    lagged_ += 0.5 * h * (slope + (light_after - guess) / rise_);
    held_ += 0.5 * h * (held_slope + (guess - held_guess) / coupling_);
  }
  std::vector<Term> terms_;
  double rise_, coupling_, lagged_ = 0, held_ = 0;
};

TEST(Photodiode, AgreesWithSmallStepsForEveryPhosphor) {
  for (const PhosphorType& type : phosphors()) {
    const Seconds rise(120e-9), coupling(2e-6);
    Photodiode diode(type.layers, kClockHz, rise, coupling);
    SteppedDiode stepped(type.layers, rise, coupling);
    const std::array<double, 3> bright{1, 0.5, 0.25}, dim{0.1, 0, 0.3}, none{};
    const std::array<std::pair<double, std::span<const double>>, 6> course{
        {{0.25, bright}, {3, bright}, {40, none}, {0.5, dim}, {1, bright}, {200, none}}};
    for (const auto& [clocks, rates] : course) {
      diode.pass(diode.span(clocks), rates);
      stepped.pass(clocks, rates);
      ASSERT_NEAR(diode.signal(), stepped.signal(), 2e-6) << type.name << " " << clocks;
    }
  }
}

TEST(Photodiode, AnyCutsOfASpanAreTheSpan) {
  const PhosphorType& type = find_phosphor("P31");
  Photodiode whole(type.layers, kClockHz, Seconds(1e-7), Seconds(1e-6)), cut = whole;
  const std::array<double, 1> rate{0.7};
  whole.pass(whole.span(30), rate);
  for (const double clocks : {0.001, 4.0, 0.999, 10.0, 15.0}) cut.pass(cut.span(clocks), rate);
  EXPECT_NEAR(whole.signal(), cut.signal(), 1e-12);
}

TEST(Photodiode, TimeConstantsMayBeEqual) {
  Phosphor phosphor;
  phosphor.terms = {{0.5, Seconds(1e-7)}, {0.5, Seconds(1e-7)}};
  const std::array layers{phosphor};
  Photodiode diode(layers, kClockHz, Seconds(1e-7), Seconds(1e-7));
  SteppedDiode stepped(layers, Seconds(1e-7), Seconds(1e-7));
  const std::array<double, 1> rate{1};
  diode.pass(diode.span(2), rate);
  stepped.pass(2, rate);
  EXPECT_NEAR(diode.signal(), stepped.signal(), 1e-3 * stepped.signal());
}

TEST(Photodiode, SteadyLightIsHeldBack) {
  const PhosphorType& type = find_phosphor("P22");
  Photodiode diode(type.layers, kClockHz, Seconds(1e-7), Seconds(1e-6));
  const std::array<double, 3> rates{1, 1, 1};
  diode.pass(diode.span(10), rates);
  EXPECT_GT(diode.signal(), 1e-4);
  diode.pass(diode.span(1e9), rates);
  EXPECT_NEAR(diode.signal(), 0, 1e-9);
  diode.darken();
  EXPECT_EQ(diode.signal(), 0);
}

}  // namespace
}  // namespace kinescope
