#include "display/tube/gun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace kinescope {
namespace {

constexpr double kClock = 25e6;

std::vector<float> currents(const GunSettings& settings, const std::vector<GunDrive>& drives,
                            Signal signal) {
  const Gun gun(settings, SpotModel(SpotSettings{}), kClock);
  std::vector<float> narrow(drives.size()), wide(drives.size());
  std::vector<float> voltage(drives.size() + 2 * static_cast<std::size_t>(gun.reach()) + 8);
  gun.doses(drives, signal, voltage, narrow.data(), wide.data());
  for (std::size_t i = 0; i < narrow.size(); ++i) narrow[i] += wide[i];
  return narrow;
}

TEST(Gun, EachFollowsItsSignal) {
  const std::vector<GunDrive> drives{{255, 128, 0}, {0, 255, 64}};
  const auto light = [](double code) { return std::pow(code / 255, 2.35); };
  EXPECT_NEAR(currents({}, drives, Signal::kRed)[0], 1, 1e-6);
  EXPECT_NEAR(currents({}, drives, Signal::kGreen)[0], light(128), 1e-6);
  EXPECT_NEAR(currents({}, drives, Signal::kBlue)[1], light(64), 1e-6);
  const double grey = std::floor((77 * 255 + 150 * 128 + 128) / 256.0);
  EXPECT_NEAR(currents({}, drives, Signal::kGrey)[0], light(grey), 1e-6);
}

TEST(Gun, KnobsMoveBlackAndWhite) {
  GunSettings settings;
  settings.contrast = 0.8;
  settings.brightness = 0.1;
  const std::vector<GunDrive> drives{{0, 0, 0}, {255, 255, 255}};
  const std::vector<float> light = currents(settings, drives, Signal::kRed);
  EXPECT_NEAR(light[0], std::pow(0.1, 2.35), 1e-6);
  EXPECT_NEAR(light[1], std::pow(0.9, 2.35), 1e-6);
  settings.brightness = -0.2;  // cut off
  EXPECT_EQ(currents(settings, drives, Signal::kRed)[0], 0);
}

TEST(Gun, SyncTipsAreBlackerThanBlack) {
  GunSettings settings;
  settings.brightness = 0.3;
  settings.blanking = 0.1;
  settings.sync = 0.4;
  const std::vector<GunDrive> black(60);
  const std::vector<CellSpan> tips{{20, 40}};
  for (const double bandwidth_hz : {0.0, 8e6}) {
    settings.bandwidth_hz = bandwidth_hz;
    const Gun gun(settings, SpotModel(SpotSettings{}), kClock);
    std::vector<float> narrow(60), wide(60);
    std::vector<float> voltage(60 + 2 * static_cast<std::size_t>(gun.reach()) + 8);
    gun.doses(black, Signal::kGreen, voltage, narrow.data(), wide.data(), tips);
    EXPECT_NEAR(narrow[10] + wide[10], std::pow(0.3, 2.35), 1e-4);
    EXPECT_NEAR(narrow[30] + wide[30], 0, 1e-6);
    EXPECT_NEAR(narrow[50] + wide[50], std::pow(0.3, 2.35), 1e-4);
  }
  const Gun gun(settings, SpotModel(SpotSettings{}), kClock);
  EXPECT_NEAR(gun.blanked_current(false), std::pow(0.2, 2.35), 1e-12);
  EXPECT_EQ(gun.blanked_current(true), 0);
}

/// A stripe's swing in the signal after the amplifier, of a sine of that frequency.
double swing(double bandwidth_hz, double frequency_hz) {
  GunSettings settings;
  settings.gamma = 1;
  settings.bandwidth_hz = bandwidth_hz;
  std::vector<GunDrive> drives;
  for (int i = 0; i < 2000; ++i) {
    const double v = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * i * frequency_hz / kClock);
    const auto code = static_cast<std::uint8_t>(std::lround(255 * v));
    drives.push_back({code, code, code});
  }
  const std::vector<float> light = currents(settings, drives, Signal::kRed);
  float low = 1, high = 0;
  for (std::size_t i = 500; i < 1500; ++i) {
    low = std::min(low, light[i]);
    high = std::max(high, light[i]);
  }
  return static_cast<double>(high - low);
}

TEST(Gun, AmplifierPassesHalfThePowerAtItsBandwidth) {
  EXPECT_NEAR(swing(0, 3.07e6), 1, 0.02);
  EXPECT_NEAR(swing(3.07e6, 3.07e6), std::numbers::sqrt2 / 2, 0.02);
  EXPECT_NEAR(swing(3.07e6, 0.2e6), 1, 0.02);
}

TEST(Gun, BothRoadsFollowOneLaw) {
  // Every drive, flat over the amplifier's memory: the table of codes and the powers agree.
  for (const double gamma : {1.0, 2.35, 3.1}) {
    GunSettings settings;
    settings.gamma = gamma;
    settings.contrast = 1.1;
    settings.brightness = -0.05;
    GunSettings slow = settings;
    slow.bandwidth_hz = 20e6;
    const SpotModel spot(SpotSettings{});
    const Gun by_table(settings, spot, kClock), by_power(slow, spot, kClock);
    ASSERT_GT(by_power.reach(), 0);
    for (int code = 0; code < 256; ++code) {
      const auto c = static_cast<std::uint8_t>(code);
      const std::vector<GunDrive> drives(32, GunDrive{c, c, c});
      std::vector<float> voltage(100), narrow(64), wide(64);
      by_table.doses(drives, Signal::kRed, voltage, narrow.data(), wide.data());
      by_power.doses(drives, Signal::kRed, voltage, narrow.data() + 32, wide.data() + 32);
      ASSERT_NEAR(narrow[16], narrow[48], 1e-4) << code;
      ASSERT_NEAR(wide[16], wide[48], 1e-4) << code;
    }
  }
}

TEST(Gun, AFineStripeDarkens) {
  std::vector<GunDrive> stripes;
  for (int i = 0; i < 200; ++i) {
    const auto code = static_cast<std::uint8_t>(i % 2 ? 255 : 0);
    stripes.push_back({code, code, code});
  }
  GunSettings settings;
  settings.bandwidth_hz = 3e6;
  const std::vector<float> light = currents(settings, stripes, Signal::kGreen);
  // The amplifier gives the mean, and gamma darkens that: half the drive is a fifth of the light.
  EXPECT_NEAR(light[100], std::pow(0.5, 2.35), 0.01);
  EXPECT_NEAR(light[101], std::pow(0.5, 2.35), 0.01);
}

TEST(Gun, AWideLineKeepsItsLevelWhateverTheBandwidth) {
  const std::vector<GunDrive> white(300, GunDrive{255, 255, 255});
  GunSettings settings;
  settings.bandwidth_hz = 2e6;
  EXPECT_NEAR(currents(settings, white, Signal::kRed)[150], 1, 2e-4);
}

}  // namespace
}  // namespace kinescope
