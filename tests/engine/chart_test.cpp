// Charts, by what a reader measures in them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/figures/chart.h"
#include "raster/fill/scanline_fill.h"
#include "raster/image/image.h"

namespace kinescope {
namespace {

constexpr ChartFrame kFrame{{10, 20}, {110, 220}};

double area(const Contour& contour) {
  double twice = 0;
  contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) { twice += a.x * b.y - b.x * a.y; });
  return std::abs(twice) / 2;
}

TEST(Chart, BarsStandOnZeroAndAreAsHighAsTheirValues) {
  const std::vector<double> values = {30, -10, 0, 70};
  const auto bars = chart_bars(values, kFrame, 0.5);
  ASSERT_EQ(bars.size(), 4u);
  const double unit = 200.0 / 80, zero = 20 + 70 * unit;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    EXPECT_NEAR(bars[i].high.y - bars[i].low.y, std::abs(values[i]) * unit, 1e-9);
    EXPECT_NEAR(values[i] < 0 ? bars[i].low.y : bars[i].high.y, zero, 1e-9);
    EXPECT_NEAR(bars[i].high.x - bars[i].low.x, 12.5, 1e-9);
    EXPECT_NEAR((bars[i].high.x + bars[i].low.x) / 2, 10 + 25 * (static_cast<double>(i) + 0.5),
                1e-9);
  }
}

TEST(Chart, ALinesPointsLieOverTheMiddlesOfTheBars) {
  const std::vector<double> values = {5, 2, -1};
  const auto points = chart_line(values, kFrame);
  const auto bars = chart_bars(values, kFrame);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(points[i].x, (bars[i].low.x + bars[i].high.x) / 2, 1e-9);
    EXPECT_NEAR(points[i].y, values[i] < 0 ? bars[i].high.y : bars[i].low.y, 1e-9);
  }
}

TEST(Chart, APiesSectorsHaveAreasLikeTheirValues) {
  const std::vector<double> values = {30, 0, 55, 80, 45};
  const auto sectors = pie_sectors(values, {50, 50}, 40);
  double before = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(sectors[i].begin_rad, before, 1e-12);
    before = sectors[i].end_rad;
    EXPECT_NEAR(area(sectors[i].contour), std::numbers::pi * 1600 * values[i] / 210, 0.3);
  }
  EXPECT_NEAR(before, 2 * std::numbers::pi, 1e-12);
}

// Which sector a pixel is in, told by the angle of its centre.
TEST(Chart, SectorsShareTheDiscsPixelsByAngle) {
  const std::vector<double> values = {1, 2, 3, 4};
  const auto sectors = pie_sectors(values, {32, 32}, 30);
  Image<int> owner(64, 64, -1);
  for (int i = 0; i < 4; ++i) {
    scanline_fill({sectors[static_cast<std::size_t>(i)].contour}, FillRule::kNonZero,
                  {0, 0, 64, 64}, [&](const RowSpan& span) {
                    for (int x = span.x_begin; x < span.x_end; ++x) {
                      EXPECT_EQ(owner.at(x, span.y), -1) << "drawn twice";
                      owner.at(x, span.y) = i;
                    }
                  });
  }
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double dx = x + 0.5 - 32, dy = y + 0.5 - 32;
      if (std::hypot(dx, dy) > 29.9) continue;
      double turn = std::atan2(dx, -dy) / (2 * std::numbers::pi);
      if (turn < 0) turn += 1;
      const int expected = turn < 0.1 ? 0 : turn < 0.3 ? 1 : turn < 0.6 ? 2 : 3;
      const double edge = std::min(
          {std::abs(turn - 0.1), std::abs(turn - 0.3), std::abs(turn - 0.6), turn, 1 - turn});
      if (edge * std::hypot(dx, dy) < 0.01) continue;
      EXPECT_EQ(owner.at(x, y), expected) << x << ", " << y;
    }
  }
}

TEST(Chart, RefusesWhatIsNoChart) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& bad : std::vector<std::vector<double>>{
           {}, {1, nan}, {1, std::numeric_limits<double>::infinity()}}) {
    EXPECT_THROW(chart_bars(bad, kFrame), Error);
    EXPECT_THROW(chart_line(bad, kFrame), Error);
    EXPECT_THROW(pie_sectors(bad, {}, 1), Error);
  }
  EXPECT_THROW(pie_sectors(std::vector<double>{2, -1}, {}, 1), Error);
  EXPECT_THROW(pie_sectors(std::vector<double>{0, 0}, {}, 1), Error);
  EXPECT_EQ(chart_bars(std::vector<double>{0, 0}, kFrame).size(), 2u) << "bars of no height";
}

}  // namespace
}  // namespace kinescope
