#include "raster/line.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "tests/raster/ascii.h"

namespace kinescope {
namespace {

using testing::AsciiCanvas;
using Points = std::vector<std::pair<int, int>>;

Points line(int x0, int y0, int x1, int y1) {
  Points points;
  bresenham(x0, y0, x1, y1, [&](int x, int y) { points.emplace_back(x, y); });
  return points;
}

TEST(Bresenham, DrawsTheTextbookLine) {
  AsciiCanvas canvas(12, 6);
  bresenham(1, 1, 9, 4, canvas);
  EXPECT_EQ(canvas.text(),
            "............\n"
            ".##.........\n"
            "...##.......\n"
            ".....###....\n"
            "........##..\n"
            "............\n");
}

TEST(Bresenham, DrawsAStarOfEightOctants) {
  AsciiCanvas canvas(11, 11);
  for (const auto& [x, y] :
       Points{{10, 7}, {7, 10}, {3, 10}, {0, 7}, {0, 3}, {3, 0}, {7, 0}, {10, 3}}) {
    BresenhamLine l(5, 5, x, y);
    for (std::int64_t i = l.steps(); i > 0; --i) {
      l.step();
      canvas(l.x(), l.y());
    }
  }
  EXPECT_EQ(canvas.text(),
            "...#...#...\n"
            "...#...#...\n"
            "....#.#....\n"
            "##..#.#..##\n"
            "..##.2.##..\n"
            "....2.2....\n"
            "..##.2.##..\n"
            "##..#.#..##\n"
            "....#.#....\n"
            "...#...#...\n"
            "...#...#...\n");
}

// Against the definition: one pixel for each step of the longer axis, both ends in it, no pixel
// further than half a pixel from the true line.
TEST(Bresenham, StaysWithinHalfAPixelInEveryOctant) {
  for (int dx = -20; dx <= 20; ++dx) {
    for (int dy = -20; dy <= 20; ++dy) {
      const int x0 = 3, y0 = -7;
      const Points points = line(x0, y0, x0 + dx, y0 + dy);
      const int steps = std::max(std::abs(dx), std::abs(dy));
      ASSERT_EQ(points.size(), static_cast<std::size_t>(steps) + 1);
      EXPECT_EQ(points.front(), std::pair(x0, y0));
      EXPECT_EQ(points.back(), std::pair(x0 + dx, y0 + dy));
      for (int i = 0; i <= steps; ++i) {
        const auto [x, y] = points[static_cast<std::size_t>(i)];
        // Twice the distance along the minor axis, times the steps.
        const int off = 2 * ((x - x0) * dy - (y - y0) * dx);
        ASSERT_LE(std::abs(off), steps) << dx << ' ' << dy << " at " << i;
        const int along = std::abs(dx) >= std::abs(dy) ? std::abs(x - x0) : std::abs(y - y0);
        ASSERT_EQ(along, i);
      }
    }
  }
}

TEST(Bresenham, ClippingRemovesPixelsAndMovesNone) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> far(-60, 80), size(0, 24);
  for (int n = 0; n < 20000; ++n) {
    const int x0 = far(random), y0 = far(random), x1 = far(random), y1 = far(random);
    const int width = size(random), height = size(random);
    Points expected, clipped;
    for (const auto& [x, y] : line(x0, y0, x1, y1)) {
      if (x >= 0 && y >= 0 && x < width && y < height) expected.emplace_back(x, y);
    }
    bresenham_clipped(x0, y0, x1, y1, width, height,
                      [&](int x, int y) { clipped.emplace_back(x, y); });
    ASSERT_EQ(clipped, expected) << x0 << ' ' << y0 << ' ' << x1 << ' ' << y1;
  }
}

// A thousand million steps long, and over at once.
TEST(Bresenham, ALongLineCostsWhatIsSeenOfIt) {
  constexpr int kFar = 1 << 29;
  int seen = 0;
  bresenham_clipped(-kFar, -kFar, kFar, kFar, 640, 480, [&](int x, int y) {
    EXPECT_EQ(x, y);
    ++seen;
  });
  EXPECT_EQ(seen, 480);
  seen = 0;
  bresenham_clipped(kFar, 100, -kFar, 101, 640, 480, [&](int x, int y) {
    EXPECT_EQ(y, x <= 0 ? 101 : 100);
    ++seen;
  });
  EXPECT_EQ(seen, 640);
  bresenham_clipped(-kFar, 700, kFar, 600, 640, 480, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace kinescope
