// Dimensions by box counting and by growth, of figures whose dimension theory or long simulations
// give. Boxes count a few octaves only: tolerances say how far such counts lie from the limit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/fractals/brownian.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/dla.h"
#include "engine/fractals/generator_curve.h"
#include "engine/fractals/plasma.h"
#include "engine/fractals/turtle.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;

double boxed(const std::vector<Vec>& points, const std::vector<double>& sizes) {
  const DimensionFit fit = fit_dimension(count_boxes(points, sizes));
  EXPECT_GT(fit.correlation, 0.99);
  return fit.dimension;
}

/// The boxes of a graph of heights over [0, 1].
double graph_dimension(const std::vector<double>& heights, double gain) {
  std::vector<Vec> points;
  const double step = 1.0 / static_cast<double>(heights.size() - 1);
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double x = step * static_cast<double>(i);
    points_along({x, gain * heights[i]}, {x + step, gain * heights[i + 1]}, 1.0 / 512,
                 [&](const Vec& p) { points.push_back(p); });
  }
  return boxed(points, {1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128, 1.0 / 256});
}

TEST(BoxDimension, ArrowheadIsSierpinskis) {
  std::vector<Vec> points;
  draw_l_system(l_system_preset("sierpinski-arrowhead"), 9, [&](const Vec& a, const Vec& b) {
    points_along(a, b, 1e-3, [&](const Vec& p) { points.push_back(p); });
  });
  EXPECT_NEAR(boxed(points, {0.25, 0.125, 0.0625, 0.03125, 0.015625}), std::log2(3.0), 0.06);
}

TEST(MoranDimension, SolvesForUnequalCopies) {
  const std::array koch = {1 / 3.0, 1 / 3.0, 1 / 3.0, 1 / 3.0};
  EXPECT_NEAR(moran_dimension(koch), std::log(4) / std::log(3), 1e-12);
  // x + x^2 = 1 at x = 2^-d: the golden ratio.
  const std::array unequal = {0.5, 0.25};
  EXPECT_NEAR(moran_dimension(unequal), std::log2((1 + std::sqrt(5.0)) / 2), 1e-12);
  EXPECT_EQ(moran_dimension(std::array{0.5, 1.0}), INFINITY);
  EXPECT_EQ(moran_dimension(std::array{0.5}), INFINITY);
}

// The plane's own construction, without a turtle: lengths and ends are Koch's.
TEST(GeneratorCurve, KochsGeneratorDrawsTheLSystemsCurve) {
  const std::array between = {Vec(1 / 3.0, 0), Vec(0.5, std::sqrt(3) / 6), Vec(2 / 3.0, 0)};
  std::vector<Vec> ends, turtles;
  generator_curve(between, {0, 0}, {1, 0}, 4,
                  [&](const Vec&, const Vec& to) { ends.push_back(to); });
  draw_l_system(l_system_preset("koch"), 4,
                [&](const Vec&, const Vec& to) { turtles.push_back(to); });
  ASSERT_EQ(ends.size(), 256u);
  ASSERT_EQ(turtles.size(), ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_NEAR(ends[i].x, turtles[i].x, 1e-12);
    EXPECT_NEAR(ends[i].y, turtles[i].y, 1e-12);
  }
  EXPECT_EQ(generator_lines(3, 4), 256);
}

TEST(GyrationDimension, ALineIsOneAndADiscIsTwo) {
  std::vector<glm::ivec2> line, disc;
  for (int i = 0; i < 500; ++i) line.emplace_back(i % 2 ? -(i + 1) / 2 : i / 2, 7);
  for (int r = 0; r < 40; ++r) {
    for (int y = -r; y <= r; ++y) {
      for (int x = -r; x <= r; ++x) {
        const int away = x * x + y * y;
        if (away >= r * r && away < (r + 1) * (r + 1)) disc.emplace_back(x, y);
      }
    }
  }
  EXPECT_NEAR(gyration_dimension(line), 1, 0.01);
  EXPECT_NEAR(gyration_dimension(disc), 2, 0.03);
  EXPECT_EQ(gyration_dimension(std::span(line).first(31)), 0);
}

// Boxes are too few for a cluster of some thousand particles. Its radius of gyration grows with
// N^(1/D); one cluster's slope is off by some 0.05.
TEST(GyrationDimension, AggregationIsNearOnePointSevenOne) {
  double mean = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Aggregation cluster(256, seed);
    while (cluster.next()) {
    }
    mean += gyration_dimension(cluster.particles) / 4;
  }
  EXPECT_NEAR(mean, 1.71, 0.1);  // 1.71: Witten and Sander; a compact cluster's is 2
}

TEST(BoxDimension, GraphsOfMotionAreTwoLessHurst) {
  for (const double hurst : {0.5, 0.7}) {
    double mean = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      MidpointLine line(hurst, seed);
      for (int level = 0; level < 12; ++level) line.next();
      mean += graph_dimension(line.heights, 1) / 4;
    }
    EXPECT_NEAR(mean, 2 - hurst, 0.12) << hurst;
  }
}

// Rough graphs fill their boxes only far below the points' distance; their law itself can be
// tested.
TEST(StructureFunction, IncrementsOfMotionGrowWithThePowerHurst) {
  for (const double hurst : {0.3, 0.5, 0.7}) {
    MidpointLine line(hurst, 1);
    for (int level = 0; level < 14; ++level) line.next();
    const auto mean_square = [&](std::size_t lag) {
      double sum = 0;
      for (std::size_t i = 0; i + lag < line.heights.size(); i += lag) {
        const double rise = line.heights[i + lag] - line.heights[i];
        sum += rise * rise;
      }
      return sum * static_cast<double>(lag) / static_cast<double>(line.heights.size() - 1);
    };
    EXPECT_NEAR(std::log2(mean_square(16) / mean_square(1)) / 8, hurst, 0.03) << hurst;
  }
}

TEST(BoxDimension, RowsOfPlasmaAreTwoLessHurst) {
  const HeightField field = plasma(10, 0.5, 4);
  double mean = 0;
  for (const int row : {100, 300, 500, 700}) {
    std::vector<double> heights;
    for (int i = 0; i < field.side; ++i) heights.push_back(field.at(i, row));
    mean += graph_dimension(heights, 1) / 4;
  }
  EXPECT_NEAR(mean, 1.5, 0.15);
}

}  // namespace
}  // namespace kinescope
