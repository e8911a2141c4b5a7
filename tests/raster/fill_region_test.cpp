// Flood and boundary fills against a plain search.
#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <random>

#include "raster/fill/boundary_fill.h"
#include "raster/fill/flood_fill.h"
#include "raster/fill/recursive_fill.h"
#include "raster/scan/sinks.h"
#include "tests/raster/pixel_set.h"

namespace kinescope {
namespace {

using testing::Pixels;
using testing::PixelSet;

template <typename Inside>
Pixels by_search(int width, int height, int x, int y, bool corners, Inside&& inside) {
  Pixels found;
  std::deque<std::pair<int, int>> open;
  const auto visit = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= width || v >= height || !inside(u, v)) return;
    if (found.emplace(u, v).second) open.emplace_back(u, v);
  };
  visit(x, y);
  while (!open.empty()) {
    const auto [u, v] = open.front();
    open.pop_front();
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        if (corners || i == 0 || j == 0) visit(u + i, v + j);
      }
    }
  }
  return found;
}

Image<int> random_image(std::mt19937& random, int width, int height, int values) {
  Image<int> image(width, height);
  std::uniform_int_distribution<int> value(0, values - 1);
  for (int& v : image.pixels()) v = value(random);
  return image;
}

TEST(FillRegion, FloodAndBoundaryFindWhatASearchFinds) {
  std::mt19937 random(21);
  for (int n = 0; n < 600; ++n) {
    const int width = 1 + n % 70, height = 1 + n % 17;
    const Image<int> image = random_image(random, width, height, 2 + n % 2);
    const int x = n * 7 % width, y = n * 5 % height;
    for (const Connectivity connectivity : {Connectivity::kFour, Connectivity::kEight}) {
      const bool corners = connectivity == Connectivity::kEight;
      PixelSet flood, boundary;
      flood_fill(image, x, y, connectivity, flood);
      boundary_fill(image, x, y, 1, connectivity, boundary);
      const int old = image.at(x, y);
      ASSERT_EQ(flood.set(), by_search(width, height, x, y, corners,
                                       [&](int u, int v) { return image.at(u, v) == old; }));
      ASSERT_EQ(boundary.set(), by_search(width, height, x, y, corners,
                                          [&](int u, int v) { return image.at(u, v) != 1; }));
      ASSERT_EQ(flood.twice() + boundary.twice(), 0);
      ASSERT_EQ(flood.empty_spans() + boundary.empty_spans(), 0);
    }
  }
}

// The sink may paint the very picture, in the old colour, the boundary's or a pattern.
TEST(FillRegion, PaintingDoesNotDisturbIt) {
  std::mt19937 random(22);
  const Image<int> image = random_image(random, 40, 30, 2);
  PixelSet expected;
  flood_fill(image, 3, 3, Connectivity::kEight, expected);
  for (const int colour : {0, 1, 7}) {
    Image<int> painted = image;
    PixelSet found;
    flood_fill(painted, 3, 3, Connectivity::kEight, [&](const RowSpan& span) {
      found(span);
      ImageSink(painted, colour)(span);
    });
    EXPECT_EQ(found.set(), expected.set());
  }
}

TEST(FillRegion, SeedsOutsideAndOnTheBoundary) {
  const Image<int> image(5, 4, 2);
  constexpr int kFar = std::numeric_limits<int>::max(), kBack = std::numeric_limits<int>::min();
  const auto fail = [](RowSpan) { FAIL(); };
  for (const auto& [x, y] : Pixels{{-1, 0}, {0, -1}, {5, 0}, {0, 4}, {kFar, kFar}, {kBack, 2}}) {
    flood_fill(image, x, y, Connectivity::kEight, fail);
    boundary_fill(image, x, y, 9, Connectivity::kFour, fail);
    Image<int> copy = image;
    RecursiveFill<int> recursive(copy, x, y, 9, 8, Connectivity::kFour, 100);
    EXPECT_FALSE(recursive.next());
  }
  boundary_fill(image, 2, 2, 2, Connectivity::kFour, fail);
  flood_fill(Image<int>(), 0, 0, Connectivity::kFour, fail);
}

TEST(FillRegion, EightConnectedLeaksThroughCornersAsTheTextbookWarns) {
  // A diagonal line of the boundary: sides do not pass it, corners do.
  Image<int> image(6, 6);
  for (int i = 0; i < 6; ++i) image.at(i, i) = 1;
  PixelSet four, eight;
  boundary_fill(image, 5, 0, 1, Connectivity::kFour, four);
  boundary_fill(image, 5, 0, 1, Connectivity::kEight, eight);
  EXPECT_EQ(four.set().size(), 15u);
  EXPECT_EQ(eight.set().size(), 30u);
}

TEST(FillRegion, RecursionFailsOnPaintedPixels) {
  Image<int> image(9, 3);
  for (int y = 0; y < 3; ++y) image.at(4, y) = 8;  // the new colour, from before
  RecursiveFill<int> recursive(image, 1, 1, 9, 8, Connectivity::kFour, 1000);
  int painted = 0;
  while (recursive.next()) ++painted;
  EXPECT_EQ(painted, 12) << "the right half is not reached";
  EXPECT_EQ(image.at(7, 1), 0);
  PixelSet spans;
  boundary_fill(image, 1, 1, 9, Connectivity::kFour, spans);
  EXPECT_EQ(spans.set().size(), 27u);
}

TEST(FillRegion, RecursionFailsOnItsStack) {
  Image<int> deep(100, 100), shallow(100, 100);
  RecursiveFill<int> enough(deep, 50, 50, 9, 8, Connectivity::kFour, 10000);
  while (enough.next()) {
  }
  EXPECT_FALSE(enough.overflowed());
  EXPECT_EQ(deep, Image<int>(100, 100, 8));
  EXPECT_GT(enough.deepest(), 5000u);
  RecursiveFill<int> little(shallow, 50, 50, 9, 8, Connectivity::kEight, 1000);
  while (little.next()) {
  }
  EXPECT_TRUE(little.overflowed());
  EXPECT_LE(little.deepest(), 1000u);
  EXPECT_NE(shallow, deep);
}

// The stack holds ranges that were not looked at: on an open field a few, however large.
TEST(FillRegion, TheStackStaysSmallOnAField) {
  const Image<int> image(500, 400);
  auto fill = flood_filler(image, 250, 200, Connectivity::kFour);
  std::size_t deepest = 0;
  int runs = 0;
  while (fill.next()) {
    deepest = std::max(deepest, fill.stack().size());
    ++runs;
  }
  EXPECT_EQ(runs, 400);
  EXPECT_LE(deepest, 900u);
}

}  // namespace
}  // namespace kinescope
