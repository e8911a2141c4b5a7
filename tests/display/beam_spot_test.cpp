#include "display/beam_spot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kinescope {
namespace {

std::vector<double> applied(const AxisWeights& axis, const std::vector<double>& cells) {
  std::vector<double> pixels;
  for (std::size_t p = 0; p < axis.start.size(); ++p) {
    double sum = 0;
    for (int t = 0; t < axis.taps; ++t) {
      sum +=
          static_cast<double>(
              axis.weight[p * static_cast<std::size_t>(axis.taps) + static_cast<std::size_t>(t)]) *
          cells[static_cast<std::size_t>(axis.start[p] + t)];
    }
    pixels.push_back(sum);
  }
  return pixels;
}

std::vector<double> flat(int cells) {
  return std::vector<double>(static_cast<std::size_t>(cells), 1);
}

double mean(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

/// Largest less least, away from the edges.
double ripple(const std::vector<double>& v) {
  const auto [low, high] = std::minmax_element(v.begin() + 12, v.end() - 12);
  return *high - *low;
}

constexpr int kPixelCounts[] = {97, 240, 300, 479, 480, 481, 600, 960, 1000, 1080, 1440, 2160};

TEST(BeamSpot, WhiteKeepsItsLightAtEveryScale) {
  for (const int pixels : kPixelCounts) {
    for (const bool swept : {false, true}) {
      EXPECT_NEAR(mean(applied(spot_weights(480, pixels, 0.3, swept), flat(480))), 1, 1e-6)
          << pixels << swept;
    }
  }
}

TEST(BeamSpot, TapsStayInsideThePicture) {
  for (const int cells : {1, 2, 3, 480}) {
    for (const int pixels : {1, 2, 7, 500, 4000}) {
      const AxisWeights axis = spot_weights(cells, pixels, 0.4, true);
      for (const int start : axis.start) {
        ASSERT_GE(start, 0);
        ASSERT_LE(start + axis.taps, cells);
      }
      EXPECT_NEAR(mean(applied(axis, flat(cells))), 1, 1e-6);
    }
  }
}

TEST(BeamSpot, SweptWhiteIsEven) {
  for (const int pixels : kPixelCounts) {
    EXPECT_LT(ripple(applied(spot_weights(480, pixels, 0.4, true), flat(480))), 4e-3) << pixels;
  }
}

TEST(BeamSpot, MagnifiedLinesAreGaussianStripes) {
  const int scale = 16;
  const std::vector<double> stripes = applied(spot_weights(30, 30 * scale, 0.3, false), flat(30));
  // The light across a line, against the sum of Gaussians averaged over a pixel by small steps.
  for (int p = 200; p < 200 + 2 * scale; ++p) {
    double want = 0;
    for (int i = 0; i < 64; ++i) {
      const double y = (p + (i + 0.5) / 64) / scale;
      for (int line = 0; line < 30; ++line) {
        const double z = (y - line - 0.5) / 0.3;
        want += std::exp(-0.5 * z * z) / (0.3 * std::sqrt(2 * M_PI)) / 64;
      }
    }
    // The spot is cut off at three deviations: half a percent of white.
    EXPECT_NEAR(stripes[static_cast<std::size_t>(p)], want, 7e-3) << p;
  }
  EXPECT_GT(ripple(stripes), 0.6);
}

TEST(BeamSpot, LinesAndPixelsDoNotBeat) {
  // Whole pixels a line repeat exactly; fractions of a line are shown where pixels can carry them
  // and are even where they cannot.
  for (const int scale : {2, 3, 4}) {
    const auto v = applied(spot_weights(480, 480 * scale, 0.3, false), flat(480));
    for (std::size_t p = 20; p < v.size() - 20; ++p) {
      ASSERT_NEAR(v[p], v[p + static_cast<std::size_t>(scale)], 1e-5) << scale;
    }
  }
  for (const int pixels : {300, 479, 481, 500, 600, 700, 800, 900, 950}) {
    EXPECT_LT(ripple(applied(spot_weights(480, pixels, 0.3, false), flat(480))), 4e-3) << pixels;
  }
}

TEST(BeamSpot, ADotIsAsWideAsItsDeviation) {
  for (const double sigma : {0.3, 0.8}) {
    std::vector<double> dot(41, 0.0);
    dot[20] = 1;
    const auto spread = applied(spot_weights(41, 410, sigma, false), dot);
    double total = 0, square = 0;
    for (std::size_t p = 0; p < spread.size(); ++p) {
      const double x = (static_cast<double>(p) + 0.5) / 10 - 20.5;
      total += spread[p];
      square += spread[p] * x * x;
    }
    EXPECT_NEAR(total / 10, 1, 2e-3);
    EXPECT_NEAR(std::sqrt(square / total), sigma, 0.02 * sigma + 0.002);
  }
}

}  // namespace
}  // namespace kinescope
