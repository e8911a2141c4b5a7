#include "display/phosphor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "display/decay.h"
#include "display/gun_drive.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// When a falling brightness passes a level.
double time_to(double level, const std::function<double(Seconds)>& brightness) {
  double low = 0, high = 10;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (brightness(Seconds(middle)) > level ? low : high) = middle;
  }
  return low;
}

/// Brightness at t after a rectangular pulse of excitation, relative to that at its end.
double after_pulse(const Phosphor& phosphor, double length, Seconds t) {
  double light = 0, start = 0;
  for (const DecayTerm& term : phosphor.terms) {
    const double built_up = term.share * (1 - std::exp(-length / term.tau.count()));
    light += built_up * std::exp(-(t / term.tau));
    start += built_up;
  }
  return light / start;
}

TEST(Phosphor, MeetsTheTektronixTableAfterLongExcitation) {
  struct Row {
    const char* name;
    double times_ms[3];
  };
  for (const Row& row :
       {Row{"P1", {27, 60, 95}}, Row{"P4", {0.32, 3.3, 20}}, Row{"P31", {0.34, 4.5, 32}}}) {
    const Phosphor& phosphor = find_phosphor(row.name);
    for (int k = 0; k < 3; ++k) {
      const double found = time_to(std::pow(10, -(k + 1)),
                                   [&](Seconds t) { return phosphor.decay_after_steady(t); });
      EXPECT_NEAR(found * 1e3, row.times_ms[k], 0.1 * row.times_ms[k]) << row.name << " " << k;
    }
  }
}

TEST(Phosphor, P22GreenMeetsBothPulses) {
  const Phosphor& green = find_phosphor("P22G");
  const auto after = [&](double length) {
    return [&green, length](Seconds t) { return after_pulse(green, length, t); };
  };
  EXPECT_NEAR(time_to(0.1, after(40e-9)) * 1e6, 12.2, 1.22);
  EXPECT_NEAR(time_to(0.1, after(100e-6)) * 1e6, 205, 20.5);
  EXPECT_NEAR(time_to(0.01, after(100e-6)) * 1e3, 2.0, 0.2);
  EXPECT_NEAR(time_to(0.001, after(100e-6)) * 1e3, 17, 1.7);
}

TEST(Phosphor, RemainingLightIsThatOfAnImpulse) {
  // Against a numeric integral of the impulse response.
  const Phosphor& p = find_phosphor("P31");
  const auto light = [&](double t) {
    double sum = 0;
    for (const DecayTerm& term : p.terms) {
      sum += term.share / term.tau.count() * std::exp(-t / term.tau.count());
    }
    return sum;
  };
  const double from = 1e-3, to = 0.4;
  const int steps = 40000;
  double integral = 0;
  for (int i = 0; i < steps; ++i) {
    integral += light(from + (to - from) * (i + 0.5) / steps) * (to - from) / steps;
  }
  EXPECT_NEAR(p.remaining(Seconds(from)), integral, 1e-4 * integral);
  EXPECT_DOUBLE_EQ(p.remaining(Seconds(0)), 1);
}

TEST(Phosphor, EveryEntryIsSound) {
  for (const Phosphor& phosphor : phosphors()) {
    double sum = 0;
    for (const DecayTerm& term : phosphor.terms) sum += term.share;
    EXPECT_NEAR(sum, 1, 1e-6) << phosphor.name;
    EXPECT_FALSE(phosphor.source.empty()) << phosphor.name;
    // Luminance 1, by the rows of the sRGB matrix.
    const LinearRgb c = phosphor.colour;
    EXPECT_NEAR(0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b, 1, 1e-3) << phosphor.name;
  }
}

TEST(Phosphor, UnknownTypesAreNamed) {
  try {
    find_phosphor("P99");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("P31"));
  }
}

TEST(Phosphor, TheThreeOfP22MakeWhite) {
  const auto layers = faceplate_phosphors("P22");
  const auto colours = layer_colours(layers);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(colours[0][c] + colours[1][c] + colours[2][c], 1, 1e-5);
    EXPECT_GT(colours[c][c], 0.8);
  }
}

/// Light of a dose by small steps, for a term of tau and a dwell of 1.
double stepped_light(double begin, double end, double tau) {
  const int steps_a_clock = 20000;
  const double dt = 1.0 / steps_a_clock;
  double held = 0, light = 0;
  for (int i = 0; i < static_cast<int>(std::lround(end * steps_a_clock)); ++i) {
    const double t = i * dt;
    double out = held * (1 - std::exp(-dt / tau));
    held -= out;
    if (t < 1 - 1e-9) {
      const double early = dt * (1 - std::exp(-dt / 2 / tau));
      out += early;
      held += dt - early;
    }
    if (t >= begin - 1e-9) light += out;
  }
  return light;
}

TEST(Decay, ClosedFormsAgreeWithSmallSteps) {
  for (const double tau : {0.05, 0.7, 3.0, 400.0}) {
    for (const auto& [begin, end] : {std::pair{0.0, 0.25},
                                     {0.0, 1.0},
                                     {0.0, 3.0},
                                     {0.25, 0.75},
                                     {0.5, 2.0},
                                     {1.0, 1.5},
                                     {1.5, 6.0}}) {
      const double want = stepped_light(begin, end, tau);
      EXPECT_NEAR(light_of_dose(begin, end, 1, tau), want, 1e-4 * want + 1e-12)
          << tau << " " << begin << " " << end;
    }
  }
}

TEST(Decay, LightAddsUpAndKeepsItsPrecisionInShortSpans) {
  for (const double tau : {1e-3, 0.3, 20.0, 1e7}) {
    double sum = 0;
    for (int i = 0; i < 3000; ++i) sum += light_of_dose(i * 1e-3, (i + 1) * 1e-3, 1, tau);
    EXPECT_NEAR(sum, light_of_dose(0, 3, 1, tau), 1e-12 * sum);
    EXPECT_NEAR(light_of_dose(0, 3, 1, tau) + left_of_dose(3, 1, tau), 1, 1e-12);
  }
}

}  // namespace
}  // namespace kinescope
