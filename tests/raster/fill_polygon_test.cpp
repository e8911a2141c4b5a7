// Polygon filling against the definition in whole numbers, and beside Cairo.
#include <cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <random>

#include "raster/base/error.h"
#include "raster/fill/inside_test.h"
#include "raster/fill/scanline_fill.h"
#include "raster/scan/sinks.h"
#include "tests/raster/ascii.h"
#include "tests/raster/pixel_set.h"

namespace kinescope {
namespace {

using testing::AsciiCanvas;
using testing::Pixels;
using testing::PixelSet;

constexpr int kSide = 24;
constexpr PixelRect kWindow{0, 0, kSide, kSide};

std::string drawn(const Polygon& polygon, FillRule rule, int width, int height) {
  AsciiCanvas canvas(width, height);
  scanline_fill(polygon, rule, {0, 0, width, height}, PointsOfSpans(canvas));
  return canvas.text();
}

/// Corners are multiples of 1/256 here, so that this is exact: whether the centre of a pixel is
/// inside, by the crossings of its row to the left.
bool by_definition(const Polygon& polygon, FillRule rule, int x, int y) {
  int crossings = 0, winding = 0;
  const std::int64_t px = 256 * x + 128, py = 256 * y + 128;
  for (const Contour& c : polygon) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      const glm::dvec2 a = c[i] * 256.0, b = c[(i + 1) % c.size()] * 256.0;
      const auto ax = static_cast<std::int64_t>(a.x), ay = static_cast<std::int64_t>(a.y);
      const auto bx = static_cast<std::int64_t>(b.x), by = static_cast<std::int64_t>(b.y);
      if ((ay <= py) == (by <= py)) continue;
      // ax + (py - ay)(bx - ax)/(by - ay) <= px
      const std::int64_t side = (px - ax) * (by - ay) - (py - ay) * (bx - ax);
      if (by > ay ? side < 0 : side > 0) continue;
      ++crossings;
      winding += by > ay ? 1 : -1;
    }
  }
  return rule == FillRule::kEvenOdd ? crossings % 2 : winding != 0;
}

Polygon random_polygon(std::mt19937& random, int contours, int corners, bool whole) {
  std::uniform_int_distribution<int> place(whole ? -2 : -512,
                                           whole ? kSide + 2 : kSide * 256 + 512);
  Polygon polygon(static_cast<std::size_t>(contours));
  for (Contour& c : polygon) {
    for (int i = 0; i < corners; ++i) {
      const glm::dvec2 p(place(random), place(random));
      c.push_back(whole ? p / 2.0 + 0.5 : p / 256.0);
    }
  }
  return polygon;
}

// Whole and half coordinates put many corners and edges on centres and rows of centres.
TEST(FillPolygon, IsTheDefinitionPixelByPixel) {
  std::mt19937 random(3);
  for (int n = 0; n < 4000; ++n) {
    const Polygon polygon = random_polygon(random, 1 + n % 3, 1 + n % 8, n % 2);
    for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
      PixelSet filled;
      scanline_fill(polygon, rule, kWindow, filled);
      Pixels expected;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          if (by_definition(polygon, rule, x, y)) expected.emplace(x, y);
          if (n % 16 < 2) {
            ASSERT_EQ(is_inside(polygon, {x + 0.5, y + 0.5}, rule),
                      by_definition(polygon, rule, x, y))
                << x << ' ' << y;
          }
        }
      }
      ASSERT_EQ(filled.set(), expected) << n;
      ASSERT_EQ(filled.twice() + filled.empty_spans(), 0) << n;
    }
  }
}

// What Cairo covers wholly is filled, and nothing that it does not touch.
TEST(FillPolygon, AgreesWithCairo) {
  std::mt19937 random(5);
  int told = 0;
  for (int n = 0; n < 500; ++n) {
    const Polygon polygon = random_polygon(random, 1 + n % 2, 3 + n % 9, false);
    const FillRule rule = n % 2 ? FillRule::kEvenOdd : FillRule::kNonZero;
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, kSide, kSide);
    cairo_t* cairo = cairo_create(surface);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_BEST);
    cairo_set_fill_rule(cairo, n % 2 ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    for (const Contour& c : polygon) {
      for (const glm::dvec2 p : c) cairo_line_to(cairo, p.x, p.y);
      cairo_close_path(cairo);
      cairo_new_sub_path(cairo);
    }
    cairo_fill(cairo);
    cairo_surface_flush(surface);
    const unsigned char* pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    PixelSet filled;
    scanline_fill(polygon, rule, kWindow, filled);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const int coverage = pixels[y * stride + x];
        const bool is_filled = filled.set().count({x, y}) != 0;
        ASSERT_TRUE(is_filled ? coverage > 0 : coverage < 255) << n << ": " << x << ' ' << y;
        told += coverage == 0 || coverage == 255;
      }
    }
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
  EXPECT_GT(told, 500 * kSide * kSide / 2);
}

TEST(FillPolygon, StarByBothRules) {
  Contour star;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 4 * std::acos(-1.0) / 5;
    star.push_back({8 + 8 * std::sin(angle), 8.5 - 8 * std::cos(angle)});
  }
  EXPECT_EQ(drawn({star}, FillRule::kNonZero, 16, 16),
            "................\n"
            "................\n"
            ".......##.......\n"
            ".......##.......\n"
            ".......##.......\n"
            "......####......\n"
            ".##############.\n"
            "..############..\n"
            "....########....\n"
            ".....######.....\n"
            ".....######.....\n"
            "....########....\n"
            "....###..###....\n"
            "....#......#....\n"
            "...#........#...\n"
            "................\n");
  EXPECT_TRUE(is_inside({star}, {8, 8.5}, FillRule::kNonZero));
  EXPECT_FALSE(is_inside({star}, {8, 8.5}, FillRule::kEvenOdd));
  InsideTest test(star, {8, 8.5});
  int edges = 0;
  while (test.next()) ++edges;
  EXPECT_EQ(edges, 5);
  EXPECT_EQ(test.crossings(), 2);
  EXPECT_EQ(std::abs(test.winding()), 2);
}

TEST(FillPolygon, HolesByEitherRule) {
  const Contour outer{{1, 1}, {9, 1}, {9, 6}, {1, 6}};
  const Contour same{{3, 2}, {7, 2}, {7, 5}, {3, 5}}, back{{3, 2}, {3, 5}, {7, 5}, {7, 2}};
  const std::string holed =
      "..........\n"
      ".########.\n"
      ".##....##.\n"
      ".##....##.\n"
      ".##....##.\n"
      ".########.\n"
      "..........\n";
  EXPECT_EQ(drawn({outer, same}, FillRule::kEvenOdd, 10, 7), holed);
  EXPECT_EQ(drawn({outer, back}, FillRule::kEvenOdd, 10, 7), holed);
  EXPECT_EQ(drawn({outer, back}, FillRule::kNonZero, 10, 7), holed);
  EXPECT_EQ(drawn({outer, same}, FillRule::kNonZero, 10, 7),
            drawn({outer}, FillRule::kNonZero, 10, 7));
}

// Triangles of a fan share edges and corners: together they cover each pixel once.
TEST(FillPolygon, NeighboursShareNoPixelAndLeaveNoGap) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> inside(1, kSide * 2 - 1);
  for (int n = 0; n < 300; ++n) {
    const glm::dvec2 middle(inside(random) / 2.0, inside(random) / 2.0);
    const Contour corners{{0, 0}, {kSide / 2.0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
    PixelSet all;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      scanline_fill({{middle, corners[i], corners[(i + 1) % corners.size()]}}, FillRule::kNonZero,
                    kWindow, all);
    }
    ASSERT_EQ(all.set().size(), static_cast<std::size_t>(kSide * kSide));
    ASSERT_EQ(all.twice(), 0);
  }
}

TEST(FillPolygon, ShowsItsActiveEdges) {
  // A corner that passes the row counts once, a peak twice, level edges not.
  ScanlineFill fill({0, 0, 20, 20}, FillRule::kEvenOdd);
  fill.add({{{2, 0.5}, {10, 0.5}, {10, 6.5}, {6, 3.5}, {2, 6.5}}});
  EXPECT_EQ(fill.waiting(), 5u);
  ASSERT_TRUE(fill.next());
  EXPECT_EQ(fill.y(), 0);
  ASSERT_EQ(fill.active_count(), 2u);
  EXPECT_EQ(fill.active(0).column, 2);
  EXPECT_EQ(fill.active(0).direction, -1);
  EXPECT_EQ(fill.active(1).column, 10);
  EXPECT_EQ(fill.waiting(), 2u);
  ASSERT_TRUE(fill.next() && fill.next() && fill.next());
  EXPECT_EQ(fill.y(), 3);
  ASSERT_EQ(fill.active_count(), 4u);
  EXPECT_EQ(fill.spans().size(), 1u) << "two runs that touch are one";
  ASSERT_TRUE(fill.next());
  // The edge from (6, 3.5) to (2, 6.5) is at 6 - 4/3 on row 4, whose first centre behind is 5.5
  // - 1.
  EXPECT_EQ(fill.active(1).column, 5);
  EXPECT_EQ(fill.active(1).remainder * 6, fill.active(1).denominator * 5)
      << "4.5 + 1/2 is 5/6 beyond 4 2/3 less 1/2";
  ASSERT_TRUE(fill.next());
  EXPECT_FALSE(fill.next());
  EXPECT_FALSE(fill.next());
}

TEST(FillPolygon, FewCornersAndBadOnes) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto fail = [](RowSpan) { FAIL(); };
  for (const Polygon& p : {Polygon{},
                           {{}},
                           {{{3, 3}}},
                           {{{3, 3}, {9, 9}}},
                           {{{3, 3}, {3, 3}, {3, 3}}},
                           {{{kNan, 3}, {9, kNan}}},
                           {{{kInfinity, 3}, {9, 9}, {4, 1}}}}) {
    scanline_fill(p, FillRule::kNonZero, kWindow, fail);
    scanline_fill(p, FillRule::kEvenOdd, kWindow, fail);
  }
  const Contour square{{2, 2}, {6, 2}, {6, 6}, {2, 6}};
  const Contour broken{{2, 2}, {kNan, 0}, {6, 2}, {6, 2}, {6, 6}, {2, 6}, {0, -kInfinity}};
  EXPECT_EQ(drawn({broken}, FillRule::kNonZero, 8, 8), drawn({square}, FillRule::kNonZero, 8, 8));
  EXPECT_THROW(scanline_fill({{{0, 0}, {1e30, 0}, {0, 5}}}, FillRule::kNonZero, kWindow, fail),
               Error);
  scanline_fill({square}, FillRule::kNonZero, {}, fail);
  scanline_fill({square}, FillRule::kNonZero, {5, 5, 2, 2}, fail);
  scanline_fill({square}, FillRule::kNonZero, {7, 0, 9, 9}, fail);
  EXPECT_THROW(ScanlineFill({0, 0, 1 << 30, 1}, FillRule::kNonZero), Error);
  const double far = ScanlineFill::kLargestCoordinate;
  PixelSet all;
  scanline_fill({{{-far, -far}, {far, -far}, {far, far}, {-far, far}}}, FillRule::kNonZero, kWindow,
                all);
  EXPECT_EQ(all.set().size(), static_cast<std::size_t>(kSide * kSide));
}

// Beside flags set at each crossing and summed along the row.
// Source of that way: B. D. Ackland and N. H. Weste, "The edge flag algorithm", 1981.
TEST(FillPolygon, AMillionCorners) {
  constexpr int kWidth = 300, kHeight = 200, kCorners = 1000000;
  std::mt19937 random(17);
  std::uniform_int_distribution<int> aside(-1500, 1500), down(-2048, 2048);
  Contour walk;
  glm::ivec2 at(kWidth * 128, kHeight * 128);
  for (int i = 0; i < kCorners; ++i) {
    at = glm::clamp(at + glm::ivec2(aside(random), down(random)), glm::ivec2(-999),
                    glm::ivec2(kWidth * 256 + 999, kHeight * 256 + 999));
    walk.push_back(glm::dvec2(at) / 256.0);
  }
  std::vector<int> flags((kWidth + 1) * kHeight);
  contour_edges(walk, [&](glm::dvec2 a, glm::dvec2 b) {
    for (int y = std::max(0, static_cast<int>(std::min(a.y, b.y)) - 1); y < kHeight; ++y) {
      const double centre = y + 0.5;
      if (centre >= std::max(a.y, b.y)) break;
      if (centre < std::min(a.y, b.y)) continue;
      // Doubles tell it apart from a whole number as far as fractions of 2^22 can lie from one.
      const double x = a.x + (centre - a.y) * (b.x - a.x) / (b.y - a.y);
      const double column = std::clamp(std::ceil(x - 0.5 - 1e-9), 0.0, double{kWidth});
      ++flags[static_cast<std::size_t>(y * (kWidth + 1)) + static_cast<std::size_t>(column)];
    }
  });
  Image<char> filled(kWidth, kHeight), expected(kWidth, kHeight);
  scanline_fill({walk}, FillRule::kEvenOdd, {0, 0, kWidth, kHeight}, ImageSink(filled, char{1}));
  for (int y = 0; y < kHeight; ++y) {
    int crossings = 0;
    for (int x = 0; x < kWidth; ++x) {
      crossings += flags[static_cast<std::size_t>(y * (kWidth + 1) + x)];
      expected.at(x, y) = static_cast<char>(crossings % 2);
    }
  }
  EXPECT_EQ(filled, expected);
}

}  // namespace
}  // namespace kinescope
