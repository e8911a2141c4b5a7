// Anti-aliased lines against areas found by cutting polygons to pixels.
#include "raster/path/stroke_coverage.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "raster/image/image.h"
#include "tests/raster/area_oracle.h"

namespace kinescope {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Coverage of a whole picture; a pixel that comes twice or lies outside is a fault.
Image<float> draw(const Segment& segment, const Stroke& stroke, int width, int height) {
  Image<float> picture(width, height, -1);
  stroke_coverage(segment, stroke, {0, 0, width, height},
                  [&](int x, int y, std::span<const float> coverage) {
                    for (const float c : coverage) {
                      ASSERT_TRUE(picture.contains(x, y));
                      ASSERT_EQ(picture.at(x, y), -1);
                      ASSERT_TRUE(c >= 0 && c <= 1);
                      picture.at(x++, y) = c;
                    }
                  });
  for (float& c : picture.pixels()) c = std::max(c, 0.0f);
  return picture;
}

void expect_area(const Segment& segment, const Stroke& stroke, int width, int height,
                 double tolerance) {
  const Image<float> picture = draw(segment, stroke, width, height);
  const Corners polygon = stroke_polygon(segment, stroke);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      ASSERT_NEAR(picture.at(x, y), std::abs(area_in_pixel(polygon, x, y)), tolerance)
          << x << ' ' << y << ": " << segment.from.x << ' ' << segment.from.y << " to "
          << segment.to.x << ' ' << segment.to.y << ", width " << stroke.width_px << ", cap "
          << static_cast<int>(stroke.cap);
    }
  }
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float between(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  /// Somewhere around a picture of that size, with a length in octaves from 2^-7 to 2^7.
  Segment segment(float size) {
    const glm::vec2 middle{between(-5, size + 5), between(-5, size + 5)};
    const float half = std::exp2(between(-7, 7)) / 2, angle = between(0, 6.2832f);
    const glm::vec2 reach = half * glm::vec2(std::cos(angle), std::sin(angle));
    return {middle - reach, middle + reach};
  }

 private:
  std::mt19937 engine_;
};

TEST(StrokeCoverage, IsTheAreaOfTheStrokeInEachPixel) {
  Random random(1);
  for (int n = 0; n < 1500; ++n) {
    const Cap cap = n % 2 ? Cap::kButt : Cap::kSquare;
    const float width = n % 3 ? random.between(0.5f, 20) : 1;
    expect_area(random.segment(24), {width, cap}, 24, 24, 2e-6);
  }
}

TEST(StrokeCoverage, RoundEndsAreWithinOneCodeOfADisc) {
  Random random(2);
  for (int n = 0; n < 60; ++n) {
    const float width = n % 3 ? random.between(0.5f, 20) : 1;
    expect_area(random.segment(14), {width, Cap::kRound}, 14, 14, 1.0 / 255);
  }
}

TEST(StrokeCoverage, AlongTheAxesAndTheDiagonals) {
  for (const float offset : {0.0f, 0.25f, 0.5f, 0.999f}) {
    for (const float width : {1.0f, 0.5f, 3.0f}) {
      for (const glm::vec2 step :
           {glm::vec2(9, 0), {0, 9}, {9, 9}, {9, -9}, {9, 1e-6f}, {1e-6f, 9}, {9, 0.01f}, {0, 0}}) {
        const glm::vec2 from{4 + offset, 10 + offset};
        for (const Cap cap : {Cap::kButt, Cap::kSquare}) {
          expect_area({from, from + step}, {width, cap}, 20, 22, 2e-6);
          expect_area({from + step, from}, {width, cap}, 20, 22, 2e-6);
        }
      }
    }
  }
}

TEST(StrokeCoverage, VeryLongLinesAreAsExact) {
  Random random(3);
  for (int n = 0; n < 300; ++n) {
    const float angle = random.between(0, 6.2832f);
    const glm::vec2 middle{random.between(0, 16), random.between(0, 16)};
    const glm::vec2 reach = random.between(0, 1e5f) * glm::vec2(std::cos(angle), std::sin(angle));
    expect_area({middle - reach, middle + reach}, {random.between(0.5f, 5), Cap::kButt}, 16, 16,
                1e-5);
  }
}

TEST(StrokeCoverage, ThinAndWideOnes) {
  Random random(4);
  for (int n = 0; n < 200; ++n) {
    expect_area(random.segment(16), {std::exp2(random.between(-20, -1)), Cap::kButt}, 16, 16, 2e-6);
    expect_area(random.segment(16), {std::exp2(random.between(4, 14)), Cap::kButt}, 16, 16, 2e-5);
  }
}

TEST(StrokeCoverage, LinesThatMeetEndToEndLeaveNoSeam) {
  Random random(5);
  for (int n = 0; n < 200; ++n) {
    const Segment whole = random.segment(24);
    const glm::vec2 between = whole.from + random.between(0, 1) * (whole.to - whole.from);
    const Stroke stroke{random.between(0.5f, 3), Cap::kButt};
    const Image<float> one = draw(whole, stroke, 24, 24);
    const Image<float> first = draw({whole.from, between}, stroke, 24, 24);
    const Image<float> second = draw({between, whole.to}, stroke, 24, 24);
    for (std::size_t i = 0; i < one.pixels().size(); ++i) {
      // The point between is rounded, so that the halves are not quite in line.
      ASSERT_NEAR(first.pixels()[i] + second.pixels()[i], one.pixels()[i], 1e-3);
    }
  }
}

TEST(StrokeCoverage, EitherWayIsTheSameLine) {
  Random random(6);
  for (int n = 0; n < 200; ++n) {
    const Segment s = random.segment(24);
    for (const Cap cap : {Cap::kButt, Cap::kSquare, Cap::kRound}) {
      const Image<float> there = draw(s, {1.5f, cap}, 24, 24);
      const Image<float> back = draw({s.to, s.from}, {1.5f, cap}, 24, 24);
      for (std::size_t i = 0; i < there.pixels().size(); ++i) {
        ASSERT_NEAR(there.pixels()[i], back.pixels()[i], 1e-6);
      }
    }
  }
}

TEST(StrokeCoverage, WhatIsNotFiniteOrHasNoWidthIsLeftOut) {
  const auto touched = [](const Segment& segment, const Stroke& stroke) {
    float sum = 0;
    const Image<float> picture = draw(segment, stroke, 8, 8);
    for (const float c : picture.pixels()) sum += c;
    return sum;
  };
  const Segment good{{1, 1}, {6, 7}};
  EXPECT_GT(touched(good, {1, Cap::kRound}), 5);
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(touched({{bad, 1}, {6, 7}}, {}), 0);
    EXPECT_EQ(touched({{1, bad}, {6, 7}}, {}), 0);
    EXPECT_EQ(touched({{1, 1}, {bad, 7}}, {}), 0);
    EXPECT_EQ(touched({{1, 1}, {6, bad}}, {}), 0);
    EXPECT_EQ(touched(good, {bad, Cap::kRound}), 0);
  }
  EXPECT_EQ(touched(good, {0, Cap::kRound}), 0);
  EXPECT_EQ(touched(good, {-1, Cap::kButt}), 0);
  EXPECT_EQ(touched({{3, 3}, {3, 3}}, {2, Cap::kButt}), 0) << "no length and no cap";
  EXPECT_NEAR(touched({{3, 3}, {3, 3}}, {2, Cap::kSquare}), 4, 1e-5);
  EXPECT_NEAR(touched({{3, 3}, {3, 3}}, {2, Cap::kRound}), 3.14159f, 1e-3);
}

TEST(StrokeCoverage, HugeCoordinatesDoNoHarm) {
  for (const float big : {1e9f, 1e20f, 1e30f, 3e38f}) {
    for (const Cap cap : {Cap::kButt, Cap::kSquare, Cap::kRound}) {
      draw({{-big, -big}, {big, big}}, {1, cap}, 8, 8);
      draw({{-big, 3}, {big, 4}}, {1, cap}, 8, 8);
      draw({{3, -big}, {3, big}}, {1, cap}, 8, 8);
      draw({{3, 3}, {4, big}}, {1, cap}, 8, 8);
      draw({{big, big}, {big, -big}}, {big, cap}, 8, 8);
    }
  }
  const Image<float> line = draw({{-1e30f, 3.5f}, {1e30f, 3.5f}}, {1, Cap::kButt}, 8, 8);
  for (int x = 0; x < 8; ++x) EXPECT_NEAR(line.at(x, 3), 1, 1e-5);
}

}  // namespace
}  // namespace kinescope
