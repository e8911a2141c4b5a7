#include "display/beam_spot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

constexpr double kLeastWeight = 1e-9;

/// A normal distribution's share below z standard deviations.
double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// Its integral up to z, for a distribution of standard deviation sigma.
double normal_integral(double z, double sigma) {
  const double s = z / sigma;
  const double density = std::exp(-0.5 * s * s) / std::sqrt(2 * std::numbers::pi);
  return z * normal_below(s) + sigma * density;
}

/// A Gaussian convolved with two boxes of unit area.
struct Profile {
  double sigma, box, second_box;  // cells

  double at(double x) const {
    if (second_box < 1e-3) {
      return (normal_below((x + box / 2) / sigma) - normal_below((x - box / 2) / sigma)) / box;
    }
    const double sum = (box + second_box) / 2, difference = (box - second_box) / 2;
    const auto n = [this](double z) { return normal_integral(z, sigma); };
    return (n(x + sum) - n(x + difference) - n(x - difference) + n(x - sum)) / (box * second_box);
  }
  /// Beyond this it holds less than a thousandth on each side.
  double radius() const { return (box + second_box) / 2 + 3.1 * sigma; }
};

/// Lines drawn with pixels of `pitch` lines: a box one line wide removes every harmonic of the
/// lines, and fades in between 0.35 and 0.5 lines a pixel. Whole numbers of pixels a line cannot
/// beat.
Profile profile_down(double sigma, double pitch, bool whole) {
  if (whole) return {sigma, pitch, 0};
  const double t = std::clamp((pitch - 0.35) / (0.5 - 0.35), 0.0, 1.0);
  const double fade = t * t * (3 - 2 * t);
  return {sigma, std::min(pitch, 1.0) + fade * (1 - std::min(pitch, 1.0)),
          std::sqrt(std::max(0.0, pitch * pitch - 1))};
}

}  // namespace

AxisWeights spot_weights(int cells, int pixels, double sigma, bool swept) {
  const double pitch = static_cast<double>(cells) / pixels;
  sigma = std::max(sigma, 1e-9);
  const Profile profile =
      swept ? Profile{sigma, 1, pitch} : profile_down(sigma, pitch, pixels % cells == 0);
  AxisWeights axis;
  axis.taps = std::min(cells, static_cast<int>(std::floor(2 * profile.radius())) + 1);
  axis.start.resize(static_cast<std::size_t>(pixels));
  std::vector<double> exact;
  std::vector<double> of_cell(static_cast<std::size_t>(cells), 0.0);
  for (int p = 0; p < pixels; ++p) {
    const double centre = (p + 0.5) * pitch - 0.5;  // in cells, 0 at the first one's centre
    const int first =
        std::clamp(static_cast<int>(std::ceil(centre - profile.radius())), 0, cells - axis.taps);
    axis.start[static_cast<std::size_t>(p)] = first;
    for (int t = 0; t < axis.taps; ++t) {
      double weight = profile.at(centre - (first + t));
      if (weight < kLeastWeight) weight = 0;
      exact.push_back(weight);
      of_cell[static_cast<std::size_t>(first + t)] += weight * pitch;
    }
  }
  // What a cell near the edge loses over it is put back; the cells between keep their weights,
  // whose sums over a pixel are even, but for what the radius cuts off.
  const double edge = profile.radius() + 0.5 * pitch;
  double kept = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const std::size_t p = i / static_cast<std::size_t>(axis.taps);
    const std::size_t cell =
        static_cast<std::size_t>(axis.start[p]) + i % static_cast<std::size_t>(axis.taps);
    const double x = static_cast<double>(cell);
    if (of_cell[cell] > 0 && std::min(x, cells - 1 - x) < edge) exact[i] /= of_cell[cell];
    kept += exact[i] * pitch;
  }
  axis.weight.reserve(exact.size());
  for (const double weight : exact)
    axis.weight.push_back(static_cast<float>(weight * cells / kept));
  return axis;
}

}  // namespace kinescope
