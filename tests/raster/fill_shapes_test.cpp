// Fills other than of polygons: regions within curves, by priority, by pattern, discs, thick lines.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "raster/fill/pattern_fill.h"
#include "raster/fill/priority_fill.h"
#include "raster/fill/round_fill.h"
#include "raster/fill/scanline_fill.h"
#include "raster/scan/midpoint_circle.h"
#include "raster/scan/midpoint_ellipse.h"
#include "raster/scan/sinks.h"
#include "raster/scan/thick_area.h"
#include "tests/raster/pixel_set.h"

namespace kinescope {
namespace {

using testing::PixelSet;

constexpr int kSide = 24;
constexpr PixelRect kWindow{0, 0, kSide, kSide};

TEST(FillShapes, CurvesBoundRegions) {
  // A circle of four cubics, to within 3e-4 of its radius.
  const float r = 10, k = r * 0.5522847f;
  Path path;
  path.move_to({r, 0});
  path.cubic_to({r, k}, {k, r}, {0, r});
  path.cubic_to({-k, r}, {-r, k}, {-r, 0});
  path.cubic_to({-r, -k}, {-k, -r}, {0, -r});
  path.cubic_to({k, -r}, {r, -k}, {r, 0});
  PixelSet pixels;
  scanline_fill(path, {1, 0, 0, 1, 12, 12}, 0.001f, FillRule::kNonZero, kWindow, pixels);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double distance = std::hypot(x + 0.5 - 12, y + 0.5 - 12);
      if (std::abs(distance - r) < 0.02) continue;
      EXPECT_EQ(pixels.set().count({x, y}) != 0, distance < r) << x << ' ' << y;
    }
  }
}

TEST(FillShapes, PriorityPaintsTheFarthestFirst) {
  const Polygon square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  std::vector<PriorityArea> areas{
      {square, 1}, {square, 5}, {square, std::nan("")}, {square, 5}, {square, -2}};
  EXPECT_EQ(painting_order(areas), (std::vector<std::size_t>{2, 1, 3, 0, 4}));
  Image<int> image(4, 4, -1);
  priority_fill(areas, kWindow, [&](std::size_t i, const RowSpan& span) {
    ImageSink(image, static_cast<int>(i))(span);
  });
  EXPECT_EQ(image, Image<int>(4, 4, 4));
}

TEST(FillShapes, PatternsRepeatAndMoveWithTheirOrigin) {
  Image<char> tile(3, 2, '.');
  tile.at(0, 0) = 'a';
  tile.at(2, 1) = 'b';
  const TilePattern<char> pattern(tile, {1, 0});
  std::string text;
  const auto write = [&](int, int, char value) { text += value; };
  PatternedSink sink(pattern, write);
  sink(RowSpan{0, -3, 6});
  EXPECT_EQ(text, ".a..a..a.");
  text.clear();
  sink(RowSpan{-1, -3, 6});
  EXPECT_EQ(text, "b..b..b..");
  EXPECT_EQ(TilePattern<char>(Image<char>()).at(3, 4), '\0');
  EXPECT_EQ(pattern.at(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()), '.');
}

TEST(FillShapes, DiscsAreWhatTheirOutlinesHold) {
  for (int a = 0; a < 30; ++a) {
    for (int b = 0; b < 30; b += 1 + b / 4) {
      PixelSet filled, outline;
      filled_ellipse({3, 4}, {a, b}, filled);
      midpoint_ellipse({3, 4}, {a, b}, outline);
      if (a == b) {
        PixelSet disc, circle;
        filled_circle({3, 4}, a, disc);
        midpoint_circle({3, 4}, a, circle);
        ASSERT_EQ(disc.twice(), 0);
        for (const auto& p : circle.set()) ASSERT_TRUE(disc.set().count(p));
        for (const auto& [x, y] : disc.set()) {
          ASSERT_TRUE(circle.set().count({x, y}) || std::hypot(x - 3, y - 4) < a);
        }
        for (int y = -a; y <= a; ++y) {
          for (int x = -a; x <= a; ++x) {
            if (x * x + y * y <= a * a) {
              ASSERT_TRUE(disc.set().count({3 + x, 4 + y}));
            }
          }
        }
      }
      ASSERT_EQ(filled.twice(), 0);
      for (const auto& [x, y] : outline.set()) ASSERT_TRUE(filled.set().count({x, y}));
      std::map<int, std::pair<int, int>> ends;
      for (const auto& [x, y] : outline.set()) {
        const auto [place, is_new] = ends.try_emplace(y, x, x);
        if (!is_new)
          place->second = {std::min(place->second.first, x), std::max(place->second.second, x)};
      }
      std::size_t expected = 0;
      for (const auto& [y, x] : ends) expected += static_cast<std::size_t>(x.second - x.first + 1);
      ASSERT_EQ(filled.set().size(), expected) << a << ' ' << b;
    }
  }
  filled_circle({0, 0}, -1, [](RowSpan) { FAIL(); });
  filled_ellipse({0, 0}, {4, -1}, [](RowSpan) { FAIL(); });
}

TEST(FillShapes, ThickLinesHaveTheirWidth) {
  for (const double angle : {0.0, 0.3, 0.8, 2.0}) {
    const glm::dvec2 u(std::cos(angle), std::sin(angle)), middle(50.25, 50.5);
    PixelSet pixels;
    thick_line_area(middle - 40.0 * u, middle + 40.0 * u, 7, {0, 0, 100, 100}, pixels);
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - middle;
        const double along = std::abs(p.x * u.x + p.y * u.y),
                     across = std::abs(p.x * u.y - p.y * u.x);
        if (std::abs(along - 40) < 0.01 || std::abs(across - 3.5) < 0.01) continue;
        ASSERT_EQ(pixels.set().count({x, y}) != 0, along < 40 && across < 3.5) << x << ' ' << y;
      }
    }
  }
  EXPECT_TRUE(thick_rectangle({1, 1}, {1, 1}, 5).empty());
  EXPECT_TRUE(thick_rectangle({1, 1}, {std::nan(""), 1}, 5).empty());
  EXPECT_TRUE(thick_rectangle({1, 1}, {4, 1}, -5).empty());
}

}  // namespace
}  // namespace kinescope
