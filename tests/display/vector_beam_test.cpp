#include "display/vector/beam_painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "display/vector/beam_stroke.h"
#include "raster/base/simd.h"
#include "raster/image/image.h"

namespace kinescope {
namespace {

/// The oracle: a spot that rests at many places, one after the other, integrated exactly over each
/// pixel.
class SteppedBeam {
 public:
  SteppedBeam(int width, int height) : width_(width), light_(width, height) {}

  void draw(const BeamStroke& s) {
    const double length = std::hypot(double{s.x1} - double{s.x0}, double{s.y1} - double{s.y0});
    const int steps = 8 + static_cast<int>(12 * length / double{s.sigma});
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) / steps;
      add(std::lerp(double{s.x0}, double{s.x1}, t), std::lerp(double{s.y0}, double{s.y1}, t),
          double{s.sigma}, 1.0 / steps);
    }
  }
  double at(int x, int y) const { return light_.at(x, y); }
  double peak() const {
    double most = 0;
    for (const double v : light_.pixels()) most = std::max(most, v);
    return most;
  }

 private:
  static double below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
  void add(double cx, double cy, double sigma, double share) {
    const auto low = [&](double c) {
      return std::max(0, static_cast<int>(std::floor(c - 7 * sigma)));
    };
    for (int y = low(cy); y < std::min<double>(light_.height(), cy + 7 * sigma); ++y) {
      const double down = below((y + 1 - cy) / sigma) - below((y - cy) / sigma);
      for (int x = low(cx); x < std::min<double>(width_, cx + 7 * sigma); ++x) {
        light_.at(x, y) += share * down * (below((x + 1 - cx) / sigma) - below((x - cx) / sigma));
      }
    }
  }
  int width_;
  Image<double> light_;
};

TiledLight painted(std::span<const BeamStroke> strokes, int width, int height, int threads = 1) {
  TiledLight light(width, height, 1);
  Workers workers(threads);
  BeamPainter painter;
  painter.draw(strokes, std::vector<float>(strokes.size(), 1.0f), light, workers);
  return light;
}

TiledLight painted(const BeamStroke& stroke, int width, int height) {
  return painted(std::span(&stroke, 1), width, height);
}

double sum_of(const TiledLight& light) {
  double sum = 0;
  for (int y = 0; y < light.height(); ++y) {
    for (int x = 0; x < light.width(); ++x) sum += static_cast<double>(light.at(0, x, y));
  }
  return sum;
}

std::vector<BeamStroke> random_strokes(int count, std::uint32_t seed, float size, float most_length,
                                       float least_sigma, float most_sigma) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  std::vector<BeamStroke> strokes;
  for (int i = 0; i < count; ++i) {
    const float x = between(0, size), y = between(0, size);
    const float angle = between(0, 6.2831853f), length = between(0, most_length);
    strokes.push_back({x, y, x + length * std::cos(angle), y + length * std::sin(angle),
                       between(least_sigma, most_sigma)});
  }
  return strokes;
}

void expect_within_a_thousandth(const BeamStroke& stroke, int size) {
  SteppedBeam want(size, size);
  want.draw(stroke);
  const TiledLight got = painted(stroke, size, size);
  const double tolerance = 1e-3 * want.peak();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      ASSERT_NEAR(static_cast<double>(got.at(0, x, y)), want.at(x, y), tolerance)
          << "from " << stroke.x0 << " " << stroke.y0 << " to " << stroke.x1 << " " << stroke.y1
          << " sigma " << stroke.sigma << " at " << x << " " << y;
    }
  }
}

TEST(VectorBeam, IsWithinAThousandthOfThePeakOfASteppedSpot) {
  for (const float sigma : {0.1f, 0.25f, 0.5f, 0.79f, 0.8f, 1.0f, 2.0f, 5.0f}) {
    std::mt19937 random(7);
    const auto between = [&](float low, float high) {
      return std::uniform_real_distribution<float>(low, high)(random);
    };
    for (const float length :
         {0.0f, 0.02f, 0.04f, 0.3f, 1.0f, 2.0f, 2.5f, 3.95f, 4.05f, 9.0f, 30.0f}) {
      for (int i = 0; i < 6; ++i) {
        // Along the axes and the diagonals too.
        const float angle = i < 3 ? static_cast<float>(i) * 0.785398163f : between(0, 6.2831853f);
        const float x = between(50, 60), y = between(50, 60), way = length * std::max(sigma, 0.5f);
        expect_within_a_thousandth(
            {x, y, x + way * std::cos(angle), y + way * std::sin(angle), sigma}, 120);
      }
    }
  }
}

TEST(VectorBeam, ConservesEnergyAtAnyResolution) {
  for (const float scale : {0.12f, 0.3f, 0.7f, 1.0f, 3.0f, 8.0f}) {
    for (BeamStroke s : random_strokes(40, 11, 30, 40, 1, 1)) {
      for (float* v : {&s.x0, &s.y0, &s.x1, &s.y1}) *v = (*v + 50) * scale;
      s.sigma = scale;
      const int size = static_cast<int>(140 * scale) + 8;
      ASSERT_NEAR(sum_of(painted(s, size, size)), 1, 1e-4) << scale;
    }
  }
}

TEST(VectorBeam, KernelAgreesWithItsScalarTwinOnEveryInstructionSet) {
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    for (const BeamStroke& s : random_strokes(60, 3, 140, 50, 0.1f, 3)) {
      const TiledLight got = painted(s, 140, 140);
      double most = 0;
      for (int y = 0; y < 140; ++y) {
        for (int x = 0; x < 140; ++x) most = std::max(most, stroke_share(s, x, y));
      }
      for (int y = 0; y < 140; ++y) {
        for (int x = 0; x < 140; ++x) {
          // Where a spot is cut off, roundings decide: 3.4e-4 of the peak.
          ASSERT_NEAR(static_cast<double>(got.at(0, x, y)), stroke_share(s, x, y), 5e-4 * most)
              << target << " " << x << " " << y << " sigma " << s.sigma;
        }
      }
    }
  }
  use_simd_target("best");
}

/// Up to six near each other, of several widths, across tiles.
BeamSpots random_spots(std::mt19937& random, int count) {
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const float x = between(8, 132), y = between(8, 132), sigma = between(0.05f, 3);
  BeamSpots spots;
  spots.count = count;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    spots.x[k] = x + between(-6, 6), spots.y[k] = y + between(-6, 6);
    spots.sigma[k] = sigma * between(0.3f, 1), spots.share[k] = between(0, 1);
  }
  return spots;
}

TEST(VectorBeam, SpotsAgreeWithTheirScalarTwinOnEveryInstructionSet) {
  Workers workers(1);
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    std::mt19937 random(9);
    for (int i = 0; i < 60; ++i) {
      BeamMarks marks;
      marks.spots.push_back(random_spots(random, 1 + i % BeamSpots::kMost));
      marks.spot_weights = {2, 0, 1};
      const BeamSpots& spots = marks.spots[0];
      TiledLight got(140, 140, 3);
      BeamPainter().draw(std::span(&marks, 1), got, workers);
      double most = 0;
      for (int y = 0; y < 140; ++y) {
        for (int x = 0; x < 140; ++x) most = std::max(most, spots_share(spots, x, y));
      }
      for (int y = 0; y < 140; ++y) {
        for (int x = 0; x < 140; ++x) {
          const double want = spots_share(spots, x, y);
          ASSERT_NEAR(static_cast<double>(got.at(0, x, y)), 2 * want, 1e-3 * most)
              << target << " " << x << " " << y;
          ASSERT_EQ(got.at(1, x, y), 0);
          ASSERT_NEAR(static_cast<double>(got.at(2, x, y)), want, 5e-4 * most) << target;
        }
      }
    }
  }
  use_simd_target("best");
}

TEST(VectorBeam, IsTheSameForAnyNumberOfThreads) {
  const auto strokes = random_strokes(20000, 5, 400, 60, 0.3f, 2);
  const TiledLight one = painted(strokes, 400, 300, 1), three = painted(strokes, 400, 300, 3);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) ASSERT_EQ(one.at(0, x, y), three.at(0, x, y));
  }
}

TEST(VectorBeam, TilesLeaveNoSeam) {
  // The same stroke, once across four tiles' corner, once within one.
  const BeamStroke s{53, 55, 76, 73, 1.3f};
  const TiledLight across = painted(s, 128, 128);
  const TiledLight within = painted({s.x0 - 48, s.y0 - 48, s.x1 - 48, s.y1 - 48, s.sigma}, 64, 64);
  for (int y = 0; y < 44; ++y) {
    for (int x = 0; x < 44; ++x) {
      ASSERT_NEAR(across.at(0, x + 48, y + 48), within.at(0, x, y), 2e-6f);
    }
  }
}

TEST(VectorBeam, EachPlaneHasItsWeight) {
  TiledLight light(64, 64, 3);
  Workers workers(1);
  BeamPainter painter;
  const std::vector<BeamStroke> strokes{{10, 10, 40, 30, 1}, {20, 50, 20, 50, 1}};
  painter.draw(strokes, std::vector<float>{1, 2, 0, 0, 0, 5}, light, workers);
  EXPECT_GT(light.at(0, 25, 20), 0);
  EXPECT_FLOAT_EQ(light.at(1, 25, 20), 2 * light.at(0, 25, 20));
  EXPECT_EQ(light.at(2, 25, 20), 0);
  EXPECT_EQ(light.at(0, 20, 50), 0);
  EXPECT_GT(light.at(2, 20, 50), 0.5f);
}

TEST(VectorBeam, LeavesOutWhatIsNotFiniteAndClipsWhatIsFarAway) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  BeamMarks spots;
  spots.spots = {{1, {nan}, {5}, {1}, {1}},
                 {2, {5, 5}, {5, infinite}, {1, 1}, {1, 1}},
                 {1, {5}, {5}, {nan}, {1}},
                 {1, {1e9f}, {-1e9f}, {1}, {1}}};
  spots.spot_weights.assign(4, 1.0f);
  TiledLight light(100, 100, 1);
  Workers workers(1);
  BeamPainter().draw(std::span(&spots, 1), light, workers);
  EXPECT_EQ(sum_of(light), 0);
  const std::vector<BeamStroke> bad{{nan, 0, 5, 5, 1},
                                    {0, 0, infinite, 5, 1},
                                    {0, 0, 5, 5, nan},
                                    {1e9f, 1e9f, 2e9f, 1e9f, 1},
                                    {-300, -300, -300, -300, 1}};
  EXPECT_EQ(sum_of(painted(bad, 100, 100)), 0);
  // 100 of 2e6 pixels of its way lie on the picture.
  EXPECT_NEAR(sum_of(painted({-1e6f, 50, 1e6f, 50, 1}, 100, 100)), 5e-5, 1e-8);
  EXPECT_NEAR(sum_of(painted({50, 1e9f, 50, -1e9f, 1}, 100, 100)) * 2e7, 1, 1e-3);
}

TEST(VectorBeam, PartsOfAStrokeAddUpToTheWhole) {
  const BeamStroke whole{20, 20, 77, 41, 1};
  std::vector<BeamStroke> parts;
  std::vector<float> weights;
  float from = 0;
  for (const float to : {0.01f, 0.1f, 0.13f, 0.5f, 0.77f, 1.0f}) {
    const auto x = [&](float t) { return whole.x0 + t * (whole.x1 - whole.x0); };
    const auto y = [&](float t) { return whole.y0 + t * (whole.y1 - whole.y0); };
    parts.push_back({x(from), y(from), x(to), y(to), 1});
    weights.push_back(to - from);
    from = to;
  }
  TiledLight sum(100, 64, 1);
  Workers workers(1);
  BeamPainter().draw(parts, weights, sum, workers);
  const TiledLight want = painted(whole, 100, 64);
  const float peak = want.at(0, 48, 30);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 100; ++x) ASSERT_NEAR(sum.at(0, x, y), want.at(0, x, y), 2e-3f * peak);
  }
}

}  // namespace
}  // namespace kinescope
