// The spot at a high voltage that sags, against a Gaussian of its own width that moves along a
// cell.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "display/tube/spot.h"
#include "display/tube/sweep_warp.h"
#include "tests/display/small_tube.h"

namespace kinescope {
namespace {

constexpr int kPixels = 4;  // of the picture, a cell
constexpr int kWhiteLines = 30, kDotLine = 41;
constexpr int kRows = 32;  // of the picture, about a dot

/// What the high voltage feels when it has long drawn such a picture, at the dots' line: stepped.
double load_at_dots(const VideoMode& mode, const SweepSettings& sweep) {
  constexpr int kSteps = 50;  // a line
  const double line_s = 1 / mode.line_rate_hz();
  const double white = static_cast<double>(mode.vertical.active) / mode.vertical.total();
  double load = 0, at_dots = 0;
  for (int frame = 0; frame < 120; ++frame) {
    for (int line = 0; line < mode.vertical.total(); ++line) {
      if (line == kDotLine) at_dots = load;
      for (int step = 0; step < kSteps; ++step) {
        const double current = line < kWhiteLines ? 1 / white : 0;
        load += (current - load) * line_s / kSteps / sweep.sag_time_s;
      }
    }
  }
  return at_dots;
}

/// Share of a Gaussian swept evenly over `length` that falls on a pixel `x` from its middle,
/// pixels.
double swept_over_pixel(double x, double sigma, double length) {
  const auto below = [&](double at) {  // the integral of the normal distribution
    const double z = at / sigma;
    return sigma * (z * 0.5 * std::erfc(-z / std::numbers::sqrt2) +
                    std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi));
  };
  const double half = 0.5 * length;
  return (below(x + 0.5 + half) - below(x - 0.5 + half) - below(x + 0.5 - half) +
          below(x - 0.5 - half)) /
         length;
}
double over_pixel(double x, double sigma) {
  const double scale = 1 / (sigma * std::numbers::sqrt2);
  return 0.5 * (std::erf((x + 0.5) * scale) - std::erf((x - 0.5) * scale));
}

struct Dot {
  int cell, code;
  double current() const { return std::pow(code / 255.0, 2.35); }
};
constexpr Dot kDots[] = {{12, 255}, {32, 170}, {52, 90}};

/// A picture that loads the high voltage, and dots in the dark below.
FrameBuffer dots_below_white(const VideoMode& mode) {
  FrameBuffer buffer = buffer_for(mode);
  for (int y = 0; y < kWhiteLines; ++y) {
    for (int x = 0; x < buffer.width(); ++x) buffer.set_pixel(0, x, y, kWhite);
  }
  for (const Dot& dot : kDots) {
    buffer.set_pixel(0, dot.cell, kDotLine, 0x010101u * static_cast<std::uint32_t>(dot.code));
  }
  return buffer;
}

/// The same picture's part about a dot.
Image<LinearRgb> part_about(const Image<LinearRgb>& picture, const Dot& dot) {
  Image<LinearRgb> part(18 * kPixels, kRows);
  const int left =
      std::clamp(dot.cell * kPixels - part.width() / 2, 0, picture.width() - part.width());
  const int top = picture.height() - kRows;
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < part.width(); ++x) part.at(x, y) = picture.at(left + x, top + y);
  }
  return part;
}

TEST(SaggedSpot, IsDrawnWithinAHundredthOfWhite) {
  const VideoMode mode = small_mode();
  for (const double sag : {0.05, 0.1, 0.2, 0.3}) {
    TubeSettings tube = fading(mode);
    tube.spot.sigma_mm = 2;  // its reach is within the lines that a curved raster sums
    tube.sweep.sag = sag;
    tube.sweep.sag_time_s = 0.2;
    FrameBuffer buffer = dots_below_white(mode);
    Workers workers(2);
    RasterTube seen(tube, 64 * kPixels, 48 * kPixels);
    seen.expose(buffer, 120 * mode.frame_period(), workers);
    const Image<LinearRgb> picture = seen.expose(buffer, 121 * mode.frame_period(), workers);

    const double voltage = voltage_at(tube.sweep, load_at_dots(mode, tube.sweep));
    EXPECT_LT(voltage, 1 - 0.4 * sag);
    const SpotModel spot(tube.spot);
    const double pixels_a_mm = 48 * kPixels / (tube.glass.diagonal_mm * 0.6);
    const double cell = kPixels / std::sqrt(voltage);  // a weaker voltage is bent further
    const double wider = spot_at_voltage(tube.spot, voltage);
    const auto sigma = [&](double current) { return wider * spot.sigma_mm(current) * pixels_a_mm; };
    const double astigmatism = spot.astigmatism();
    const double white =
        swept_over_pixel(0, sigma(1) * astigmatism, cell) * over_pixel(0, sigma(1));
    double energy = 0;  // of white
    for (const Dot& dot : kDots) {
      const Image<LinearRgb> part = part_about(picture, dot);
      const Centre centre = centre_of(part);
      if (energy == 0) energy = centre.light;
      const double own = sigma(dot.current());
      double off = 0;
      for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x) {
          const double across =
              swept_over_pixel(x + 0.5 - centre.x * part.width(), own * astigmatism, cell);
          const double down = over_pixel(y + 0.5 - centre.y * part.height(), own);
          const double got = static_cast<double>(part.at(x, y).g) / energy;
          off = std::max(off, std::abs(got - dot.current() * across * down) / white);
        }
      }
      EXPECT_LT(off, 0.01) << sag << " " << dot.code;
    }
  }
}

}  // namespace
}  // namespace kinescope
