// Anti-aliased coverage beside exact areas, and edges blurred after the fact.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "raster/antialias/area_coverage.h"
#include "raster/antialias/edge_blur.h"
#include "raster/antialias/filtered_coverage.h"
#include "raster/antialias/supersample.h"
#include "tests/raster/area_oracle.h"

namespace kinescope {
namespace {

using Weights = std::map<std::pair<int, int>, double>;
constexpr PixelRect kWindow{-3, -2, 17, 14};
const Polygon kTriangle{{{-1.3, 0.2}, {14.1, 4.7}, {5.5, 11.9}}};

template <typename Cover>
Weights weights(Cover&& cover) {
  Weights all;
  cover([&](int x, int y, float weight) {
    EXPECT_GT(weight, 0);
    EXPECT_TRUE(all.emplace(std::pair(x, y), weight).second) << x << ' ' << y << " twice";
  });
  return all;
}

double at(const Weights& all, int x, int y) {
  const auto found = all.find({x, y});
  return found == all.end() ? 0 : found->second;
}

double total(const Weights& all) {
  double sum = 0;
  for (const auto& [place, weight] : all) sum += weight;
  return sum;
}

TEST(Antialias, EachMethodComesToTheArea) {
  const auto area =
      weights([](auto sink) { area_coverage(kTriangle, FillRule::kNonZero, kWindow, sink); });
  const auto four =
      weights([](auto sink) { supersample(kTriangle, FillRule::kNonZero, kWindow, 4, sink); });
  const auto many =
      weights([](auto sink) { supersample(kTriangle, FillRule::kNonZero, kWindow, 64, sink); });
  const auto box = weights([](auto sink) {
    filtered_coverage(kTriangle, FillRule::kNonZero, kWindow, CoverageFilter::kBox, 64, sink);
  });
  for (int y = kWindow.y0; y < kWindow.y1; ++y) {
    for (int x = kWindow.x0; x < kWindow.x1; ++x) {
      const double exact = std::abs(area_in_pixel(kTriangle[0], x, y));
      EXPECT_NEAR(at(area, x, y), exact, 1e-3) << x << ' ' << y;
      EXPECT_NEAR(at(four, x, y), exact, 0.3) << x << ' ' << y;
      EXPECT_NEAR(at(many, x, y), exact, 0.03) << x << ' ' << y;
      EXPECT_NEAR(at(box, x, y), exact, 0.03) << x << ' ' << y;
    }
  }
}

TEST(Antialias, FiltersSpreadAndKeepTheSum) {
  const double area = std::abs(signed_area(kTriangle[0]));
  std::size_t before = 0;
  for (const CoverageFilter filter :
       {CoverageFilter::kBox, CoverageFilter::kTent, CoverageFilter::kGaussian}) {
    EXPECT_EQ(filter_share(filter, -9), 0);
    EXPECT_EQ(filter_share(filter, 9), 1);
    EXPECT_NEAR(filter_share(filter, 0), 0.5, 1e-12);
    const auto all = weights([&](auto sink) {
      filtered_coverage(kTriangle, FillRule::kNonZero, kWindow, filter, 16, sink);
    });
    EXPECT_NEAR(total(all), area, 0.1);
    EXPECT_GT(all.size(), before);
    before = all.size();
    for (const auto& [place, weight] : all) EXPECT_LE(weight, 1.0001);
  }
}

TEST(Antialias, NothingAndBadNumbers) {
  const auto fail = [](int, int, float) { FAIL(); };
  for (const Polygon& p : {Polygon{}, {{}}, {{{1, 1}, {5, 5}}}, {{{std::nan(""), 1}, {5, 5}}}}) {
    area_coverage(p, FillRule::kEvenOdd, kWindow, fail);
    supersample(p, FillRule::kEvenOdd, kWindow, 4, fail);
    filtered_coverage(p, FillRule::kEvenOdd, kWindow, CoverageFilter::kTent, 4, fail);
  }
  supersample(kTriangle, FillRule::kEvenOdd, {}, 4, fail);
  area_coverage(kTriangle, FillRule::kEvenOdd, {}, fail);
  filtered_coverage(kTriangle, FillRule::kEvenOdd, {}, CoverageFilter::kBox, 4, fail);
  const auto one =
      weights([](auto sink) { supersample(kTriangle, FillRule::kNonZero, kWindow, -5, sink); });
  for (const auto& [place, weight] : one) EXPECT_EQ(weight, 1);
}

TEST(Antialias, EdgeBlurSmoothsAStairAndNothingElse) {
  // An edge that falls one pixel in four: black above, white below.
  Image<LinearRgb> stair(48, 32), smooth(48, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) {
      const double exact = std::clamp(y + 1 - (8 + (x + 0.5) / 4), 0.0, 1.0);
      const float white = exact >= 0.5 ? 1 : 0, grey = static_cast<float>(exact);
      stair.at(x, y) = {white, white, white};
      smooth.at(x, y) = {grey, grey, grey};
    }
  }
  const Image<LinearRgb> blurred = blur_edges(stair);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < stair.pixels().size(); ++i) {
    before += std::pow(stair.pixels()[i].g - smooth.pixels()[i].g, 2);
    after += std::pow(blurred.pixels()[i].g - smooth.pixels()[i].g, 2);
  }
  EXPECT_LT(after, 0.75 * before);
  EXPECT_EQ(blurred.at(3, 2), stair.at(3, 2));
  EXPECT_EQ(blurred.at(40, 30), stair.at(40, 30));
  const Image<LinearRgb> even(9, 9, {0.3f, 0.2f, 0.1f});
  EXPECT_EQ(blur_edges(even), even);
  EXPECT_TRUE(blur_edges(Image<LinearRgb>()).empty());
  Image<LinearRgb> bad(3, 3);
  bad.at(1, 1) = {std::nanf(""), 1e30f, -5};
  blur_edges(bad);
}

}  // namespace
}  // namespace kinescope
