#include "raster/path/exact_area.h"

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <limits>
#include <random>

#include "raster/path/flatten.h"

namespace kinescope {
namespace {

using Polygon = std::vector<glm::vec2>;
using Coverage = std::vector<float>;

void add(ExactArea& area, const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    area.add_edge(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
}

Coverage coverage(ExactArea& area, FillRule rule = FillRule::kNonZero) {
  Coverage all;
  area.rows(rule, [&](int, std::span<const float> row) {
    all.insert(all.end(), row.begin(), row.end());
  });
  return all;
}

Coverage coverage(int width, int height, const Polygon& polygon,
                  FillRule rule = FillRule::kNonZero) {
  ExactArea area(width, height);
  add(area, polygon);
  return coverage(area, rule);
}

float total(const Coverage& coverage) {
  float sum = 0;
  for (const float c : coverage) sum += c;
  return sum;
}

/// Twice the signed area, by the surveyor's formula.
double shoelace(const Polygon& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec2 a = p[i], b = p[(i + 1) % p.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

TEST(ExactArea, CoversRectanglesByTheirShareOfEachPixel) {
  const Coverage c = coverage(4, 3, {{0.5f, 0.25f}, {2.75f, 0.25f}, {2.75f, 2.5f}, {0.5f, 2.5f}});
  const Coverage expected{0.375f, 0.75f, 0.5625f, 0,  //
                          0.5f,   1,     0.75f,   0,  //
                          0.25f,  0.5f,  0.375f,  0};
  ASSERT_EQ(c.size(), expected.size());
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(c[i], expected[i], 1e-6) << i;
}

TEST(ExactArea, CoversATriangleByItsAreaWhicheverWayItTurns) {
  for (const Polygon& p : {Polygon{{0, 0}, {2, 0}, {0, 2}}, Polygon{{0, 0}, {0, 2}, {2, 0}}}) {
    const Coverage c = coverage(2, 2, p);
    const Coverage expected{1, 0.5f, 0.5f, 0};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(c[i], expected[i], 1e-6) << i;
  }
}

TEST(ExactArea, TotalIsThePolygonsArea) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0, 30);
  for (int n = 0; n < 2000; ++n) {
    const Polygon p{{place(random), place(random)},
                    {place(random), place(random)},
                    {place(random), place(random)}};
    ASSERT_NEAR(total(coverage(30, 30, p)), std::abs(shoelace(p)) / 2, 1e-3);
  }
}

// What is cut off at the sides must not change a pixel inside.
TEST(ExactArea, ClippingLeavesThePixelsInside) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> place(-25, 45);
  for (int n = 0; n < 500; ++n) {
    Polygon p, moved;
    for (int i = 0; i < 5; ++i) {
      p.push_back({place(random), place(random)});
      moved.push_back(p.back() + glm::vec2(30, 30));
    }
    const Coverage window = coverage(20, 20, p), whole = coverage(80, 80, moved);
    for (std::size_t y = 0; y < 20; ++y) {
      for (std::size_t x = 0; x < 20; ++x) {
        ASSERT_NEAR(window[y * 20 + x], whole[(y + 30) * 80 + x + 30], 2e-4)
            << n << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(ExactArea, HugeAndBrokenCoordinatesDoNoHarm) {
  constexpr float kBig = 1e30f, kNan = std::numeric_limits<float>::quiet_NaN();
  const Coverage c = coverage(4, 4, {{-kBig, -kBig}, {kBig, -kBig}, {kBig, kBig}, {-kBig, kBig}});
  for (const float value : c) EXPECT_NEAR(value, 1, 1e-5);
  for (const float value : coverage(4, 4, {{kNan, 0}, {3, kNan}, {1, 3}}))
    EXPECT_TRUE(value >= 0 && value <= 1);
  EXPECT_TRUE(coverage(0, 0, {{0, 0}, {1, 1}, {0, 1}}).empty());
  EXPECT_EQ(total(coverage(3, 3, {})), 0);
}

TEST(ExactArea, FillRules) {
  // A square within a square, turning the same way.
  const Polygon outer{{0, 0}, {5, 0}, {5, 5}, {0, 5}}, inner{{1, 1}, {4, 1}, {4, 4}, {1, 4}};
  ExactArea area(5, 5);
  add(area, outer);
  add(area, inner);
  EXPECT_NEAR(total(coverage(area, FillRule::kNonZero)), 25, 1e-5);
  EXPECT_EQ(total(coverage(area, FillRule::kNonZero)), 0) << "the rows were taken";
  add(area, outer);
  add(area, inner);
  EXPECT_NEAR(total(coverage(area, FillRule::kEvenOdd)), 16, 1e-5);
}

// FreeType's rasterizer is exact too, for straight edges in its own 1/64 of a pixel.
TEST(ExactArea, AgreesWithFreeTypeOnPolygons) {
  FT_Library library;
  ASSERT_EQ(FT_Init_FreeType(&library), 0);
  std::mt19937 random(9);
  constexpr int kSide = 40;
  std::uniform_int_distribution<int> place(0, kSide * 64);
  for (int n = 0; n < 1000; ++n) {
    std::vector<FT_Vector> points;
    Polygon p;
    for (int i = 0; i < 3 + n % 5; ++i) {
      const int x = place(random), y = place(random);
      points.push_back({x, y});
      p.push_back({static_cast<float>(x) / 64, kSide - static_cast<float>(y) / 64});
    }
    std::vector<char> tags(points.size(), FT_CURVE_TAG_ON);
    short last = static_cast<short>(points.size() - 1);
    const bool even_odd = n % 2;
    FT_Outline outline{1,
                       static_cast<short>(points.size()),
                       points.data(),
                       tags.data(),
                       &last,
                       even_odd ? FT_OUTLINE_EVEN_ODD_FILL : FT_OUTLINE_NONE};
    std::vector<unsigned char> pixels(kSide * kSide);
    FT_Bitmap bitmap{kSide, kSide, kSide, pixels.data(), 256, FT_PIXEL_MODE_GRAY, 0, nullptr};
    ASSERT_EQ(FT_Outline_Get_Bitmap(library, &outline, &bitmap), 0);
    const Coverage c =
        coverage(kSide, kSide, p, even_odd ? FillRule::kEvenOdd : FillRule::kNonZero);
    for (std::size_t i = 0; i < c.size(); ++i) {
      // It cuts edges at 1/256 of a pixel and rounds down.
      ASSERT_NEAR(c[i] * 255, pixels[i], 2.5) << n << ": " << i % kSide << ' ' << i / kSide;
    }
  }
  FT_Done_FreeType(library);
}

/// The largest distance from points of the curve to the chords.
template <typename Curve>
float deviation(const Polygon& chords, Curve&& at) {
  float worst = 0;
  for (int i = 0; i <= 4000; ++i) {
    const glm::vec2 p = at(static_cast<float>(i) / 4000);
    float nearest = 1e9f;
    for (std::size_t k = 0; k + 1 < chords.size(); ++k) {
      const glm::vec2 d = chords[k + 1] - chords[k];
      const float square = glm::dot(d, d);
      const float t = square > 0 ? glm::clamp(glm::dot(p - chords[k], d) / square, 0.0f, 1.0f) : 0;
      nearest = std::min(nearest, glm::length(p - chords[k] - t * d));
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

TEST(Flatten, StaysWithinTheToleranceAndNotFarBelow) {
  for (const float tolerance : {0.5f, 0.05f, 0.005f}) {
    const glm::vec2 a{0, 0}, b{10, 40}, c{50, -30}, d{60, 20};
    Polygon quadratic{a}, cubic{a};
    flatten_quadratic(a, b, d, tolerance, [&](glm::vec2 p) { quadratic.push_back(p); });
    flatten_cubic(a, b, c, d, tolerance, [&](glm::vec2 p) { cubic.push_back(p); });
    EXPECT_EQ(quadratic.back(), d);
    EXPECT_EQ(cubic.back(), d);
    const float off2 = deviation(quadratic, [&](float t) {
      const float s = 1 - t;
      return s * s * a + 2 * s * t * b + t * t * d;
    });
    const float off3 = deviation(cubic, [&](float t) {
      const float s = 1 - t;
      return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    });
    EXPECT_LE(off2, tolerance * 1.01f);
    EXPECT_LE(off3, tolerance * 1.01f);
    EXPECT_GT(off2, tolerance / 8) << "more chords than needed";
    EXPECT_GT(off3, tolerance / 8) << "more chords than needed";
  }
}

TEST(Flatten, BrokenCurvesGiveOneChord) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  int count = 0;
  flatten_quadratic({0, 0}, {kNan, 0}, {1, 1}, 0.1f, [&](glm::vec2) { ++count; });
  EXPECT_EQ(count, 1);
  flatten_cubic({0, 0}, {1e30f, 0}, {0, 1e30f}, {1, 1}, 0.1f, [&](glm::vec2) { ++count; });
  EXPECT_LE(count, 65537);
}

}  // namespace
}  // namespace kinescope
