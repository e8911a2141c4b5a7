// Test patterns beside the levels that their standards publish.
#include "display/patterns/patterns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "raster/base/error.h"

namespace kinescope {
namespace {

/// R'G'B' drive of a published 8-bit Y'CbCr of BT.601, cut off as a gun does.
std::array<double, 3> drive_of(int y, int cb, int cr) {
  const double luma = (y - 16) / 219.0, u = (cb - 128) / 224.0, v = (cr - 128) / 224.0;
  const double r = luma + 1.402 * v, b = luma + 1.772 * u;
  const double g = (luma - 0.299 * r - 0.114 * b) / 0.587;
  std::array<double, 3> drive{r, g, b};
  for (double& d : drive) d = 255 * std::clamp(d, 0.0, 1.0);
  return drive;
}

void expect_published(Srgb8 p, int y, int cb, int cr, const char* what) {
  const auto drive = drive_of(y, cb, cr);
  EXPECT_NEAR(p.r, drive[0], 2.5) << what;  // a code of luma and one of chroma
  EXPECT_NEAR(p.g, drive[1], 2.5) << what;
  EXPECT_NEAR(p.b, drive[2], 2.5) << what;
}

TEST(SmpteBars, HaveThePublishedLevels) {
  const Image<Srgb8> p = smpte_bars(700, 480);
  const auto bar = [&](int i) { return p.at(50 + 100 * i, 100); };
  // ITU-R BT.801-1's codes for 75% bars.
  expect_published(bar(0), 180, 128, 128, "grey");
  expect_published(bar(1), 162, 44, 142, "yellow");
  expect_published(bar(2), 131, 156, 44, "cyan");
  expect_published(bar(3), 112, 72, 58, "green");
  expect_published(bar(4), 84, 184, 198, "magenta");
  expect_published(bar(5), 65, 100, 212, "red");
  expect_published(bar(6), 35, 212, 114, "blue");
  EXPECT_EQ(bar(0), (Srgb8{191, 191, 191, 255}));
  EXPECT_EQ(bar(3), (Srgb8{0, 191, 0, 255}));
  // EG 1's foot: -I, 100% white, +Q.
  expect_published(p.at(60, 470), 16, 158, 95, "-I");
  EXPECT_EQ(p.at(190, 470), (Srgb8{255, 255, 255, 255}));
  expect_published(p.at(310, 470), 16, 174, 149, "+Q");
}

TEST(SmpteBars, CastellationsStandUnderTheirBlue) {
  const Image<Srgb8> p = smpte_bars(700, 480);
  for (int i = 0; i < 7; ++i) {
    const Srgb8 above = p.at(50 + 100 * i, 310), below = p.at(50 + 100 * i, 340);
    EXPECT_EQ(above.b, below.b) << i;  // what the blue-only switch shows must match
  }
  for (const int i : {1, 3, 5}) EXPECT_EQ(p.at(50 + 100 * i, 340), Srgb8{});
  EXPECT_EQ(p.at(50, 340), (Srgb8{0, 0, 191, 255}));
  EXPECT_EQ(p.at(250, 340), (Srgb8{191, 0, 191, 255}));
}

TEST(SmpteBars, PartsHaveTheirShares) {
  const Image<Srgb8> p = smpte_bars(840, 480);  // a bar is 120, -I 150, a stripe 40
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(p.at(120 * i, 0), p.at(120 * i + 119, 319));
    EXPECT_NE(p.at(120 * i + 119, 0), p.at(120 * i + 120, 0));
  }
  EXPECT_NE(p.at(0, 319), p.at(0, 320));  // two thirds
  EXPECT_EQ(p.at(0, 320), p.at(0, 359));
  EXPECT_NE(p.at(0, 359), p.at(0, 360));  // a twelfth
  EXPECT_NE(p.at(149, 400), p.at(150, 400));
  EXPECT_EQ(p.at(150, 400), p.at(299, 400));
  EXPECT_NE(p.at(299, 400), p.at(300, 400));
  EXPECT_EQ(p.at(449, 400), p.at(300, 400));
  EXPECT_EQ(p.at(450, 400), Srgb8{});
  // PLUGE: 3.5, 7.5 and 11.5 IRE; the first cannot be told from black.
  for (const int x : {600, 639, 640, 679, 720, 839}) EXPECT_EQ(p.at(x, 400), Srgb8{}) << x;
  const auto lighter = static_cast<std::uint8_t>(std::lround(255 * (11.5 - 7.5) / 92.5));
  for (const int x : {680, 719}) {
    EXPECT_EQ(p.at(x, 400), (Srgb8{lighter, lighter, lighter, 255})) << x;
  }
}

TEST(EbuBars, AreAHundredZeroSeventyFiveZero) {
  const Image<Srgb8> p = ebu_bars(720, 576);
  const std::array<Srgb8, 8> bars{Srgb8{255, 255, 255}, Srgb8{191, 191, 0}, Srgb8{0, 191, 191},
                                  Srgb8{0, 191, 0},     Srgb8{191, 0, 191}, Srgb8{191, 0, 0},
                                  Srgb8{0, 0, 191},     Srgb8{0, 0, 0}};
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(p.at(90 * i, 0), bars[static_cast<std::size_t>(i)]) << i;
    EXPECT_EQ(p.at(90 * i + 89, 575), bars[static_cast<std::size_t>(i)]) << i;
  }
}

TEST(Pluge, HasTheCodesOfItsSources) {
  const Image<Srgb8> p = pluge(1000, 500);
  const auto drive = [](int code) {
    return static_cast<std::uint8_t>(std::lround(255 * std::max(0.0, (code - 64) / 876.0)));
  };
  EXPECT_EQ(p.at(185, 250).g, 0);          // 48: below black
  EXPECT_EQ(p.at(335, 250).g, drive(80));  // 2% above
  EXPECT_GT(p.at(335, 250).g, 0);
  EXPECT_EQ(p.at(250, 250).g, 0);
  const std::array codes{940, 720, 560, 448, 360};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(p.at(700, 90 + 80 * i).g, drive(codes[static_cast<std::size_t>(i)])) << i;
  }
  for (const Srgb8 c : p.pixels()) ASSERT_TRUE(c.r == c.g && c.g == c.b);
}

TEST(Crosshatch, CutsAFaceInto16By12Squares) {
  const Image<Srgb8> p = crosshatch(641, 481);
  for (int x = 0; x < 641; ++x) EXPECT_EQ(p.at(x, 20).g, x % 40 == 0 ? 255 : 0) << x;
  for (int y = 0; y < 481; ++y) EXPECT_EQ(p.at(20, y).g, y % 40 == 0 ? 255 : 0) << y;
}

TEST(ConvergenceDots, StandWhereLinesWouldCross) {
  const Image<Srgb8> p = convergence_dots(642, 482);
  int lit = 0;
  for (int y = 0; y < 482; ++y) {
    for (int x = 0; x < 642; ++x) {
      const bool dot = x % 40 < 2 && y % 40 < 2;
      ASSERT_EQ(p.at(x, y).g, dot ? 255 : 0) << x << ' ' << y;
      lit += dot;
    }
  }
  EXPECT_EQ(lit, 17 * 13 * 4);
}

TEST(GreySteps, AreTenPerCentApart) {
  const Image<Srgb8> p = grey_steps(1100, 100);
  for (int i = 0; i <= 10; ++i) {
    EXPECT_EQ(p.at(50 + 100 * i, 10).r, std::lround(25.5 * i)) << i;
    EXPECT_EQ(p.at(50 + 100 * i, 90).r, std::lround(25.5 * (10 - i))) << i;
  }
}

TEST(ZonePlate, FrequencyGrowsToHalfACycleAPixelAtTheSides) {
  const int width = 640, height = 480;
  const Image<Srgb8> p = zone_plate(width, height);
  EXPECT_EQ(p.at(320, 240).g, 255);
  // Instantaneous frequency is x / width: between x0 and x1 there are (x1^2 - x0^2) / 2 width
  // turns.
  const auto maxima = [&](int from, int to, bool across) {
    int count = 0;
    for (int i = from; i < to; ++i) {
      const auto at = [&](int k) {
        return across ? p.at(width / 2 + k, height / 2).g : p.at(width / 2, height / 2 + k).g;
      };
      count += at(i) > at(i - 1) && at(i) >= at(i + 1);
    }
    return count;
  };
  EXPECT_NEAR(maxima(40, 240, true), (240.0 * 240 - 40.0 * 40) / (2 * width), 1.5);
  // A circle on a 4:3 face of square pixels is as fine down as across.
  EXPECT_NEAR(maxima(40, 200, false), (200.0 * 200 - 40.0 * 40) / (2 * width), 1.5);
  for (int x = 305; x < 319; ++x) {  // near the side black and white alternate
    EXPECT_GT(std::abs(p.at(320 + x, 240).g - p.at(321 + x, 240).g), 60) << x;
  }
}

TEST(TestPatterns, AreOfAnySizeAndFoundByName) {
  std::set<std::string_view> names;
  for (const TestPattern& pattern : test_patterns()) {
    EXPECT_TRUE(names.insert(pattern.name).second);
    EXPECT_EQ(&find_test_pattern(pattern.name), &pattern);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 3), std::pair(710, 480)}) {
      const Image<Srgb8> p = pattern.draw(width, height);
      EXPECT_EQ(p.width(), width);
      EXPECT_EQ(p.height(), height);
      for (const Srgb8 c : p.pixels()) ASSERT_EQ(c.a, 255) << pattern.name;
    }
  }
  try {
    find_test_pattern("indian-head");
    FAIL();
  } catch (const Error& error) {
    for (const std::string_view name : names) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(std::string(name)));
    }
  }
}

}  // namespace
}  // namespace kinescope
