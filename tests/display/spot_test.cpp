#include "display/tube/spot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

double gaussian(double r, double sigma) {
  return std::exp(-0.5 * r * r / (sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma);
}

TEST(Spot, GrowsWithTheCubeRootOfTheCurrent) {
  SpotSettings settings;
  settings.sigma_mm = 0.2;
  settings.least = 0.5;
  const SpotModel spot(settings);
  EXPECT_DOUBLE_EQ(spot.sigma_mm(1), 0.2);
  EXPECT_DOUBLE_EQ(spot.sigma_mm(0), 0.1);
  EXPECT_DOUBLE_EQ(spot.sigma_mm(0.125), 0.15);
  settings.focus = 3;
  EXPECT_DOUBLE_EQ(SpotModel(settings).sigma_mm(1), 0.6);
}

TEST(Spot, TwoGaussiansDrawEverySpotWithinAHundredthOfWhite) {
  for (const double least : {0.6, 0.7, 0.8, 1.0}) {
    SpotSettings settings;
    settings.least = least;
    const SpotModel spot(settings);
    const double white = gaussian(0, spot.sigma_mm(1));
    double largest = 0;
    for (double current = 0; current <= 1; current += 0.01) {
      const double wide = spot.wide_part(current), sigma = spot.sigma_mm(current);
      ASSERT_GE(wide, 0);
      ASSERT_LE(wide, current);
      for (double r = 0; r < 4 * sigma; r += 0.02 * sigma) {
        const double want = current * gaussian(r, sigma);
        const double got =
            (current - wide) * gaussian(r, spot.narrow_mm()) + wide * gaussian(r, spot.wide_mm());
        largest = std::max(largest, std::abs(got - want) / white);
      }
    }
    EXPECT_LT(largest, 0.01) << least;
  }
}

TEST(Spot, AtALowerVoltageItsAreaGrowsAsMuch) {
  for (const double voltage : {1.0, 0.9, 0.7}) {
    const double times = spot_at_voltage(SpotSettings{}, voltage);
    EXPECT_DOUBLE_EQ(times * times, 1 / voltage);
  }
}

TEST(Spot, OfNoWidthNeedsOneGaussianOnly) {
  SpotSettings settings;
  settings.sigma_mm = 0;
  EXPECT_EQ(SpotModel(settings).wide_part(0.7), 0);
}

}  // namespace
}  // namespace kinescope
