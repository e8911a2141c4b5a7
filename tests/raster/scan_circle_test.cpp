// Circles and arcs against whole-number definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "raster/base/error.h"
#include "raster/scan/arc.h"
#include "raster/scan/bresenham_circle.h"
#include "raster/scan/dda_ellipse.h"
#include "raster/scan/explicit_circle.h"
#include "raster/scan/midpoint_circle.h"
#include "raster/scan/parametric_circle.h"
#include "tests/raster/ascii.h"
#include "tests/raster/pixel_set.h"

namespace kinescope {
namespace {

using testing::AsciiCanvas;
using testing::Pixels;
using testing::PixelSet;
using Points = std::vector<std::pair<int, int>>;

template <typename Octant>
Points octant(int radius) {
  Points points;
  for (Octant circle(radius); circle.next();) points.emplace_back(circle.at().x, circle.at().y);
  return points;
}

/// The pixels nearest to the circle in each column of the octant: (2y - 1)^2 < 4 (r^2 - x^2) <
/// (2y + 1)^2, in which an odd square never equals a multiple of 4.
Points by_definition(std::int64_t r) {
  Points points;
  for (std::int64_t x = 0; x <= r; ++x) {
    const std::int64_t four = 4 * (r * r - x * x);
    std::int64_t y = 0;
    while ((2 * y + 1) * (2 * y + 1) < four) ++y;
    if (x > y) break;
    points.emplace_back(x, y);
  }
  return points;
}

TEST(ScanCircle, TheTextbooksRadiusOfTen) {
  const Points expected{{0, 10}, {1, 10}, {2, 10}, {3, 10}, {4, 9}, {5, 9}, {6, 8}, {7, 7}};
  EXPECT_EQ(octant<BresenhamCircle>(10), expected);
  EXPECT_EQ(octant<MidpointCircle>(10), expected);
  EXPECT_EQ(octant<ExplicitCircle>(10), expected);
  std::vector<std::int64_t> bresenham, midpoint;
  for (BresenhamCircle c(10); c.next();) bresenham.push_back(c.decision());
  for (MidpointCircle c(10); c.next();) midpoint.push_back(c.decision());
  EXPECT_EQ(bresenham, (std::vector<std::int64_t>{-17, -11, -1, 13, -5, 17, 11, 13}));
  EXPECT_EQ(midpoint, (std::vector<std::int64_t>{-9, -6, -1, 6, -3, 8, 5, 6}));
}

TEST(ScanCircle, NearestPixelsByEveryExactMethod) {
  for (int r = 0; r <= 300; ++r) {
    const Points expected = by_definition(r);
    ASSERT_EQ(octant<BresenhamCircle>(r), expected) << r;
    ASSERT_EQ(octant<MidpointCircle>(r), expected) << r;
    ASSERT_EQ(octant<ExplicitCircle>(r), expected) << r;
  }
}

TEST(ScanCircle, DrawsAPicture) {
  AsciiCanvas canvas(13, 13);
  midpoint_circle({6, 6}, 5, canvas);
  EXPECT_EQ(canvas.text(),
            ".............\n"
            "....#####....\n"
            "...#.....#...\n"
            "..#.......#..\n"
            ".#.........#.\n"
            ".#.........#.\n"
            ".#.........#.\n"
            ".#.........#.\n"
            ".#.........#.\n"
            "..#.......#..\n"
            "...#.....#...\n"
            "....#####....\n"
            ".............\n");
}

// Bresenham's and the midpoint circle: no difference to show, no pixel twice, no gap.
TEST(ScanCircle, WholeCirclesAreEqualAndClosed) {
  for (int r = 0; r <= 120; ++r) {
    PixelSet bresenham, midpoint, by_root, parametric, dda, walk;
    bresenham_circle({3, -4}, r, bresenham);
    midpoint_circle({3, -4}, r, midpoint);
    explicit_circle({3, -4}, r, by_root);
    parametric_circle({3, -4}, r, parametric);
    dda_circle({3, -4}, r, dda);
    arc({3, -4}, r, 1, 7, walk);
    ASSERT_EQ(bresenham.set(), midpoint.set()) << r;
    ASSERT_EQ(by_root.set(), midpoint.set()) << r;
    ASSERT_EQ(walk.set(), midpoint.set()) << r;
    ASSERT_EQ(midpoint.twice() + bresenham.twice() + walk.twice(), 0) << r;
    ASSERT_TRUE(walk.is_chain(true)) << r;
    for (const PixelSet* p : {&midpoint, &parametric, &dda}) {
      ASSERT_TRUE(r == 0 || p->is_loop()) << r;
      for (const auto& [x, y] : p->set()) {
        // Half a pixel aside; the parametric one rounds both ways, the DDA leans by a quarter more.
        const double far = p == &midpoint ? 0.5 : p == &parametric ? 0.708 : 0.96;
        ASSERT_LE(std::abs(std::hypot(x - 3, y + 4) - r), far) << r;
      }
    }
    ASSERT_TRUE(dda.is_chain(true)) << r;
  }
}

TEST(ScanCircle, NegativeAndHugeRadii) {
  const auto fail = [](int, int) { FAIL(); };
  for (const int r : {-1, -7, std::numeric_limits<int>::min()}) {
    bresenham_circle({0, 0}, r, fail);
    midpoint_circle({0, 0}, r, fail);
    midpoint_circle_clipped({0, 0}, r, {-9, -9, 9, 9}, fail);
    explicit_circle({0, 0}, r, fail);
    parametric_circle({0, 0}, r, fail);
    dda_circle({0, 0}, r, fail);
    arc({0, 0}, r, 0, 7, fail);
  }
  constexpr int kHuge = std::numeric_limits<int>::max();
  EXPECT_THROW(bresenham_circle({0, 0}, kHuge, fail), Error);
  EXPECT_THROW(midpoint_circle({0, 0}, kHuge, fail), Error);
  EXPECT_THROW(midpoint_circle({kHuge, 0}, 5, fail), Error);
  EXPECT_THROW(midpoint_circle_clipped({0, 0}, kHuge, {-9, -9, 9, 9}, fail), Error);
  EXPECT_THROW(dda_circle({0, kHuge}, 5, fail), Error);
  EXPECT_THROW(arc({0, 0}, kHuge, 0, 7, fail), Error);
  // The largest that are allowed.
  PixelSet largest;
  midpoint_circle({0, 0}, kLargestRadius, [&](int x, int y) {
    if (x == 0 || y == 0) largest(x, y);
  });
  EXPECT_EQ(largest.set().size(), 4u);
}

TEST(ScanCircle, ClippingRemovesPixelsAndMovesNone) {
  for (int r = 0; r <= 40; ++r) {
    for (const PixelRect window : {PixelRect{-5, -5, 9, 12},
                                   {20, -30, 31, 40},
                                   {-60, 3, 60, 4},
                                   {0, 0, 1, 50},
                                   {-60, -60, 60, 60},
                                   {5, 5, 5, 9}}) {
      PixelSet expected, clipped;
      midpoint_circle({2, 1}, r, [&](int x, int y) {
        if (x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1) expected(x, y);
      });
      midpoint_circle_clipped({2, 1}, r, window, clipped);
      ASSERT_EQ(clipped.set(), expected.set()) << r << ": " << window.x0 << ' ' << window.y0;
      ASSERT_EQ(clipped.twice(), 0);
    }
  }
}

// A circle of half a thousand million pixels, over at once.
TEST(ScanCircle, AHugeCircleCostsWhatIsSeenOfIt) {
  constexpr int kFar = 1 << 29;
  PixelSet seen;
  midpoint_circle_clipped({-kFar + 100, 0}, kFar, {0, -200, 640, 200}, seen);
  EXPECT_EQ(seen.set().size(), 400u);
  for (const auto& [x, y] : seen.set()) EXPECT_EQ(x, 100);
  int count = 0;
  midpoint_circle_clipped(
      {0, 0}, kFar, {379625000, 379625000, 379625100, 379625200}, [&](int x, int y) {
        ++count;
        // |x^2 + y^2 - r^2| <= r, half a pixel
        const std::int64_t error =
            std::int64_t{x} * x + std::int64_t{y} * y - std::int64_t{kFar} * kFar;
        EXPECT_LE(std::abs(error), kFar + std::int64_t{kFar} / 2);
      });
  EXPECT_GE(count, 99);
}

TEST(ScanCircle, ArcsHoldTheirDirectionsInOrder) {
  constexpr double kPi = std::numbers::pi;
  for (const int r : {1, 2, 5, 16, 37}) {
    for (const double start : {0.0, 0.3, 1.7, -2.0, 5.5}) {
      for (const double sweep : {0.2, 1.2, kPi / 2 + 0.1, 3.3, 5.1, -0.7, -4.0}) {
        PixelSet pixels, whole;
        arc({0, 0}, r, start, sweep, pixels);
        midpoint_circle({0, 0}, r, whole);
        Pixels expected;
        for (const auto& [x, y] : whole.set()) {
          // Turned so that the sector begins at 0.
          double angle = std::atan2(y, x) - std::min(start, start + sweep);
          angle -= 2 * kPi * std::floor(angle / (2 * kPi));
          if (angle <= std::abs(sweep)) expected.emplace(x, y);
        }
        ASSERT_EQ(pixels.set(), expected) << r << ": " << start << ' ' << sweep;
        ASSERT_EQ(pixels.twice(), 0);
        ASSERT_TRUE(pixels.is_chain(false)) << r << ": " << start << ' ' << sweep;
        PixelSet clipped;
        arc_clipped({0, 0}, r, start, sweep, {-50, -50, 50, 50}, clipped);
        ASSERT_EQ(clipped.set(), expected);
      }
    }
  }
  PixelSet quarter;
  arc({10, 20}, 5, 0, kPi / 2, quarter);
  EXPECT_EQ(quarter.order().front(), std::pair(15, 20));
  EXPECT_EQ(quarter.order().back(), std::pair(10, 25));
  arc({0, 0}, 9, std::nan(""), 1, [](int, int) { FAIL(); });
  arc({0, 0}, 9, 0, std::numeric_limits<double>::infinity(), [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace kinescope
