#include "display/tube/axis_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kinescope {
namespace {

constexpr int kMargin = 8;  // cells beside the picture that pixels show too

/// Pixels of a picture of `cells`, and of its surroundings, kMargin cells wide on both sides.
struct Axis {
  AxisWeights weights;
  int cells;
  double pitch;  // cells a pixel
};

Axis spot_axis(int cells, int pixels, double sigma_cells, bool swept) {
  const double pitch = static_cast<double>(cells) / pixels;
  const int margin = static_cast<int>(std::ceil(kMargin / pitch));
  std::vector<double> edges;
  for (int i = -margin; i <= pixels + margin; ++i) edges.push_back(i * pitch);
  const double sigma = sigma_cells / pitch;
  return {axis_weights(edges, {sigma, sigma}, pitch, swept), cells, pitch};
}

/// What all pixels see, those beside the picture too.
std::vector<double> applied_with_margin(const Axis& axis, const std::vector<double>& cells) {
  std::vector<double> pixels;
  const int count =
      static_cast<int>(2 * std::ceil(kMargin / axis.pitch) + std::lround(axis.cells / axis.pitch));
  for (int p = 0; p < count; ++p) {
    double sum = 0;
    for (int t = 0; t < axis.weights.taps; ++t) {
      const int cell = axis.weights.start[static_cast<std::size_t>(p)] + t;
      if (cell < 0 || cell >= axis.cells) continue;
      sum += static_cast<double>(axis.weights.at(0, p, t)) * cells[static_cast<std::size_t>(cell)];
    }
    pixels.push_back(sum);
  }
  return pixels;
}

/// What the picture's own pixels see.
std::vector<double> applied(const Axis& axis, const std::vector<double>& cells) {
  const std::vector<double> all = applied_with_margin(axis, cells);
  const auto margin = static_cast<std::ptrdiff_t>(std::ceil(kMargin / axis.pitch));
  return {all.begin() + margin, all.end() - margin};
}

std::vector<double> flat(int cells) {
  return std::vector<double>(static_cast<std::size_t>(cells), 1);
}

/// Largest less least, away from the edges.
double ripple(const std::vector<double>& v) {
  const auto [low, high] = std::minmax_element(v.begin() + 12, v.end() - 12);
  return *high - *low;
}

constexpr int kPixelCounts[] = {97, 240, 300, 479, 480, 481, 600, 960, 1000, 1080, 1440, 2160};

TEST(AxisWeights, NoLightIsLostAtAnyScale) {
  for (const int pixels : kPixelCounts) {
    for (const bool swept : {false, true}) {
      const Axis axis = spot_axis(480, pixels, 0.3, swept);
      double total = 0;
      for (const double v : applied_with_margin(axis, flat(480))) total += v * axis.pitch;
      EXPECT_NEAR(total, 480, 1e-3 * 480) << pixels << swept;
    }
  }
}

TEST(AxisWeights, EndlessWhiteIsOneOnAverage) {
  for (const int pixels : kPixelCounts) {
    for (const bool swept : {false, true}) {
      const Axis axis = spot_axis(480, pixels, 0.3, swept);
      double total = 0;
      const int shown = static_cast<int>(2 * std::ceil(kMargin / axis.pitch)) + pixels;
      for (int p = 0; p < shown; ++p) {
        for (int t = 0; t < axis.weights.taps; ++t) {
          total += static_cast<double>(axis.weights.at(0, p, t));
        }
      }
      EXPECT_NEAR(total / shown, 1, 1e-6) << pixels << swept;
    }
  }
}

TEST(AxisWeights, WhiteIsOneInsideThePictureAndFallsOffAtItsEdge) {
  for (const int pixels : kPixelCounts) {
    const auto v = applied(spot_axis(480, pixels, 0.3, true), flat(480));
    for (std::size_t p = 12; p + 12 < v.size(); ++p) ASSERT_NEAR(v[p], 1, 2e-6) << pixels;
    EXPECT_LT(v.front(), 1);
    EXPECT_GT(v.front(), 0.4);
    EXPECT_NEAR(v.front(), v.back(), 2e-4);
  }
}

TEST(AxisWeights, TinyPicturesHaveAllTheirLight) {
  for (const int cells : {1, 2, 3}) {
    for (const int pixels : {1, 2, 7, 500}) {
      const Axis axis = spot_axis(cells, pixels, 0.4, true);
      double total = 0;
      for (const double v : applied_with_margin(axis, flat(cells))) total += v * axis.pitch;
      EXPECT_NEAR(total, cells, 5e-3 * cells) << cells << " in " << pixels;
    }
  }
}

TEST(AxisWeights, SweptWhiteIsEven) {
  for (const int pixels : kPixelCounts) {
    EXPECT_LT(ripple(applied(spot_axis(480, pixels, 0.4, true), flat(480))), 2e-6) << pixels;
  }
}

TEST(AxisWeights, MagnifiedLinesAreGaussianStripes) {
  const int scale = 16;
  const std::vector<double> stripes = applied(spot_axis(30, 30 * scale, 0.3, false), flat(30));
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

TEST(AxisWeights, LinesAndPixelsDoNotBeat) {
  // Whole pixels a line repeat exactly; fractions of a line are shown where pixels can carry them
  // and are even where they cannot.
  for (const int scale : {2, 3, 4}) {
    const auto v = applied(spot_axis(480, 480 * scale, 0.3, false), flat(480));
    for (std::size_t p = 20; p < v.size() - 20; ++p) {
      ASSERT_NEAR(v[p], v[p + static_cast<std::size_t>(scale)], 1e-5) << scale;
    }
  }
  for (const int pixels : {300, 479, 481, 500, 600, 700, 800, 900, 950}) {
    EXPECT_LT(ripple(applied(spot_axis(480, pixels, 0.3, false), flat(480))), 4e-3) << pixels;
  }
}

TEST(AxisWeights, ADotIsAsWideAsItsDeviation) {
  for (const double sigma : {0.3, 0.8}) {
    std::vector<double> dot(41, 0.0);
    dot[20] = 1;
    const auto spread = applied(spot_axis(41, 410, sigma, false), dot);
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
