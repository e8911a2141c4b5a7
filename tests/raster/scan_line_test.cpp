// Lines against exact fractions: DDA, Bresenham, Wu, thick and dashed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "raster/base/error.h"
#include "raster/scan/bresenham_steps.h"
#include "raster/scan/dashed.h"
#include "raster/scan/dda_line.h"
#include "raster/scan/sinks.h"
#include "raster/scan/thick_pen.h"
#include "raster/scan/thick_replicated.h"
#include "raster/scan/wu_line.h"
#include "tests/raster/ascii.h"
#include "tests/raster/pixel_set.h"

namespace kinescope {
namespace {

using testing::AsciiCanvas;
using testing::Pixels;
using testing::PixelSet;

constexpr int kReach = 23;

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

template <typename Body>
void every_direction(Body&& body) {
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) body(dx, dy);
  }
}

TEST(ScanLine, DdaRoundsTheExactFractions) {
  every_direction([](int dx, int dy) {
    const int n = std::max(std::abs(dx), std::abs(dy));
    DdaLine line({3, -5}, {3 + dx, -5 + dy});
    for (int i = 0; i <= n; ++i) {
      ASSERT_TRUE(line.next());
      for (const auto& [at, delta] : {std::pair(line.at().x - 3, dx), {line.at().y + 5, dy}}) {
        if (n == 0) {
          ASSERT_EQ(at, 0);
          continue;
        }
        // floor(i delta / n + 1/2); sums of rounded steps may miss a tie, and nothing else.
        const int exact = floor_div(2 * i * delta + n, 2 * n);
        const bool tie = floor_div(2 * i * delta + n, 2 * n) * 2 * n == 2 * i * delta + n;
        ASSERT_TRUE(at == exact || (tie && at == exact - 1)) << dx << ' ' << dy << ": " << i;
      }
    }
    ASSERT_FALSE(line.next());
    ASSERT_FALSE(line.next());
  });
}

// Practical 1: value by value. The two differ only where the line passes exactly between two
// pixels.
TEST(ScanLine, DdaAndBresenhamDifferOnlyOnTies) {
  int differing = 0;
  every_direction([&](int dx, int dy) {
    const int n = std::max(std::abs(dx), std::abs(dy));
    DdaLine dda({0, 0}, {dx, dy});
    BresenhamSteps bresenham({0, 0}, {dx, dy});
    for (int i = 0; i <= n; ++i) {
      ASSERT_TRUE(dda.next() && bresenham.next());
      if (dda.at() == bresenham.at()) continue;
      ++differing;
      const int minor = std::min(std::abs(dx), std::abs(dy));
      ASSERT_EQ(2 * i * minor % (2 * n), n) << dx << ' ' << dy << " at " << i;
    }
    ASSERT_FALSE(dda.next() || bresenham.next());
  });
  EXPECT_GT(differing, 0);
}

TEST(ScanLine, BresenhamShowsItsDecisions) {
  // The textbook's (20, 10) to (30, 18): p0 = 2 dy - dx = 6, then 2, -2, 14, 10, 6, 2, -2, 14, 10.
  BresenhamSteps line({20, 10}, {30, 18});
  std::vector<std::int64_t> decisions;
  std::vector<int> heights;
  while (line.next()) {
    decisions.push_back(line.decision());
    heights.push_back(line.at().y);
  }
  EXPECT_EQ(decisions, (std::vector<std::int64_t>{6, 2, -2, 14, 10, 6, 2, -2, 14, 10, 6}));
  EXPECT_EQ(heights, (std::vector<int>{10, 11, 12, 12, 13, 14, 15, 16, 16, 17, 18}));
}

TEST(ScanLine, BadEndsGiveNothingOrSayWhy) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 bad : {glm::dvec2(kNan, 0), {0, kNan}, {kInfinity, 0}, {0, 1e10}}) {
    dda_line({0, 0}, bad, [](int, int) { FAIL(); });
    dda_line(bad, {0, 0}, [](int, int) { FAIL(); });
  }
  constexpr int kFar = std::numeric_limits<int>::min();
  EXPECT_THROW(BresenhamSteps({0, 0}, {kFar, 0}), Error);
  EXPECT_THROW(WuLine({0, kFar}, {0, 0}), Error);
  EXPECT_THROW(pen_line({0, kFar}, {0, 0}, Pen::round(3), [](RowSpan) {}), Error);
  int points = 0;
  dda_line({4, 4}, {4, 4}, [&](int x, int y) {
    EXPECT_EQ(glm::ivec2(x, y), glm::ivec2(4, 4));
    ++points;
  });
  wu_line({4, 4}, {4, 4}, [&](int, int, float weight) {
    EXPECT_EQ(weight, 1);
    ++points;
  });
  EXPECT_EQ(points, 2);
}

TEST(ScanLine, WuWeightsAreTheExactFractions) {
  every_direction([](int dx, int dy) {
    const int n = std::max(std::abs(dx), std::abs(dy)), m = std::min(std::abs(dx), std::abs(dy));
    const bool steep = std::abs(dy) > std::abs(dx);
    std::map<int, double> sums, moments;
    wu_line({7, 9}, {7 + dx, 9 + dy}, [&](int x, int y, float weight) {
      const int along = std::abs(steep ? y - 9 : x - 7), aside = std::abs(steep ? x - 7 : y - 9);
      ASSERT_GT(weight, 0);
      sums[along] += weight;
      moments[along] += weight * aside;
    });
    ASSERT_EQ(sums.size(), static_cast<std::size_t>(n) + 1);
    for (const auto& [along, sum] : sums) {
      ASSERT_NEAR(sum, 1, 1e-6);
      ASSERT_NEAR(moments[along], n ? double(along) * m / n : 0, 1e-5) << dx << ' ' << dy;
    }
  });
}

TEST(ScanLine, ReplicatedColumnsAreAsHighAsTheyShould) {
  PixelSet pixels;
  replicated_line({2, 3}, {22, 10}, 4, pixels);
  EXPECT_EQ(pixels.twice(), 0);
  EXPECT_EQ(pixels.set().size(), 21u * 4);
  EXPECT_EQ(replicas({0, 0}, {10, 0}, 5), 5);
  EXPECT_EQ(replicas({0, 0}, {10, 10}, 5), 7) << "5 sqrt 2";
  EXPECT_EQ(replicas({0, 0}, {0, 0}, 5), 5);
  EXPECT_EQ(replicas({0, 0}, {1, 0}, std::nan("")), 1);
}

TEST(ScanLine, PensTouchWhatTheyPassOver) {
  for (const Pen& pen : {Pen::round(1), Pen::round(2), Pen::round(5), Pen::square(4)}) {
    every_direction([&](int dx, int dy) {
      PixelSet stamped, spans;
      bresenham(0, 0, dx, dy, [&](int x, int y) {
        for (RowSpan row : pen.rows) stamped({row.y + y, row.x_begin + x, row.x_end + x});
      });
      pen_line({0, 0}, {dx, dy}, pen, spans);
      ASSERT_EQ(spans.set(), stamped.set()) << dx << ' ' << dy;
      ASSERT_EQ(spans.twice(), 0);
    });
  }
  AsciiCanvas canvas(7, 7);
  pen_line({3, 3}, {3, 3}, Pen::round(5), PointsOfSpans(canvas));
  EXPECT_EQ(canvas.text(),
            ".......\n"
            "..###..\n"
            ".#####.\n"
            ".#####.\n"
            ".#####.\n"
            "..###..\n"
            ".......\n");
  EXPECT_TRUE(Pen::round(0).rows.empty());
  EXPECT_TRUE(Pen::round(-4).rows.empty());
  pen_line({0, 0}, {9, 9}, Pen::round(-4), [](RowSpan) { FAIL(); });
}

std::string dashes(std::vector<int> lengths, std::int64_t phase, int count = 20) {
  DashPattern pattern(std::move(lengths), phase);
  std::string text;
  for (int i = 0; i < count; ++i) text += pattern.next() ? '#' : '.';
  return text;
}

TEST(ScanLine, DashesFollowTheirPattern) {
  EXPECT_EQ(dashes({3, 2}, 0), "###..###..###..###..");
  EXPECT_EQ(dashes({3, 2}, 1), "##..###..###..###..#");
  EXPECT_EQ(dashes({3, 2}, -1), ".###..###..###..###.");
  EXPECT_EQ(dashes({3, 2}, 5'000'000'004), ".###..###..###..###.");
  EXPECT_EQ(dashes({4, 1, 1, 1}, 0), "####.#.####.#.####.#");
  EXPECT_EQ(dashes({3}, 0), "###...###...###...##");
  EXPECT_EQ(dashes({0, 2, 3, 0}, 0), "..###..###..###..###");
  for (const std::vector<int>& solid : {std::vector<int>{}, {0, 0}, {-1, -5}}) {
    EXPECT_EQ(dashes(solid, 7), std::string(20, '#'));
  }
  AsciiCanvas canvas(12, 2);
  DashPattern pattern({2, 1});
  bresenham(0, 0, 11, 1, DashedSink(pattern, canvas));
  EXPECT_EQ(canvas.text(), "##.##.......\n......##.##.\n");
}

TEST(ScanLine, SinksClip) {
  Image<int> image(4, 3);
  ImageSink sink(image, 7);
  sink(-1, 0);
  sink(4, 0);
  sink(0, 3);
  sink(RowSpan{-1, 0, 4});
  sink(RowSpan{3, 0, 4});
  sink(RowSpan{1, 5, 9});
  sink(RowSpan{1, -9, 0});
  EXPECT_EQ(image, (Image<int>(4, 3)));
  sink(RowSpan{1, -9, 2});
  sink(3, 2);
  Image<int> expected(4, 3);
  expected.at(0, 1) = expected.at(1, 1) = expected.at(3, 2) = 7;
  EXPECT_EQ(image, expected);
  PixelSet seen;
  ClippedSink clipped(PixelRect{2, 1, 5, 4}, seen);
  clipped(RowSpan{2, 0, 9});
  clipped(RowSpan{0, 0, 9});
  clipped(RowSpan{3, 0, 2});
  clipped(4, 3);
  clipped(5, 3);
  EXPECT_EQ(seen.set(), (Pixels{{2, 2}, {3, 2}, {4, 2}, {4, 3}}));
}

}  // namespace
}  // namespace kinescope
