#include "display/tube/axis_weights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

constexpr double kReach = 3;     // standard deviations
constexpr double kLeast = 1e-9;  // cells: a spot of no width

/// A normal distribution's share below z standard deviations.
double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// Its integral up to z, for a distribution of standard deviation sigma.
double normal_integral(double z, double sigma) {
  const double s = z / sigma;
  const double density = std::exp(-0.5 * s * s) / std::sqrt(2 * std::numbers::pi);
  return z * normal_below(s) + sigma * density;
}

/// A Gaussian convolved with two boxes of unit area: of an output pixel, and of the beam's way
/// across a cell. Widths in cells.
struct Profile {
  double sigma, box, second_box;

  double at(double x) const {
    if (second_box < 1e-3) {
      return (normal_below((x + box / 2) / sigma) - normal_below((x - box / 2) / sigma)) / box;
    }
    const double sum = (box + second_box) / 2, difference = (box - second_box) / 2;
    const auto n = [this](double z) { return normal_integral(z, sigma); };
    return (n(x + sum) - n(x + difference) - n(x - difference) + n(x - sum)) / (box * second_box);
  }
  double radius() const { return (box + second_box) / 2 + kReach * sigma; }
};

double fade_between(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Lines drawn with pixels of `pitch` lines: a box one line wide removes every harmonic of the
/// lines, and fades in between 0.35 and 0.5 lines a pixel. Whole numbers of pixels a line cannot
/// beat.
Profile profile_down(double sigma, double pitch) {
  const double pixels = 1 / pitch;
  if (pixels > 0.5 && std::abs(pixels - std::round(pixels)) < 1e-6) return {sigma, pitch, 0};
  const double fade = fade_between(0.35, 0.5, pitch);
  return {sigma, std::min(pitch, 1.0) + fade * (1 - std::min(pitch, 1.0)),
          std::sqrt(std::max(0.0, pitch * pitch - 1))};
}

Profile profile_of(double sigma_pixels, double pitch, bool swept) {
  const double sigma = std::max(sigma_pixels * pitch, kLeast);
  return swept ? Profile{sigma, 1, pitch} : profile_down(sigma, pitch);
}

/// Weights of one Gaussian, tap after tap, from where each pixel's taps start.
void fill_weights(AxisWeights& axis, std::span<const double> edges, std::size_t basis,
                  double sigma_pixels, double cells_a_pixel, bool swept) {
  const int pixels = static_cast<int>(edges.size()) - 1;
  std::vector<double> exact(static_cast<std::size_t>(axis.taps * pixels));
  double total = 0;
  for (int p = 0; p < pixels; ++p) {
    const std::size_t at = static_cast<std::size_t>(p);
    const double pitch = edges[at + 1] - edges[at], middle = 0.5 * (edges[at] + edges[at + 1]);
    const Profile profile = profile_of(sigma_pixels, pitch, swept);
    double* const own = exact.data() + static_cast<std::ptrdiff_t>(p) * axis.taps;
    double sum = 0;
    for (int t = 0; t < axis.taps; ++t) {
      const double weight = profile.at(axis.start[at] + t + 0.5 - middle);
      own[t] = weight > kLeast ? weight : 0;  // rounding lights no dark cells
      sum += own[t];
    }
    total += sum;
    // Along the sweep cells leave no gaps: their weights add up to 1 at every pixel, across it only
    // on the average.
    const double scale = pitch / cells_a_pixel / (swept ? sum : 1);
    for (int t = 0; t < axis.taps; ++t) own[t] *= scale;
  }
  const double scale = swept ? 1 : pixels / total;
  axis.weight[basis].assign(static_cast<std::size_t>(axis.taps * axis.pitch), 0.0f);
  for (int p = 0; p < pixels; ++p) {
    for (int t = 0; t < axis.taps; ++t) {
      axis.weight[basis][static_cast<std::size_t>(t * axis.pitch + p)] =
          static_cast<float>(exact[static_cast<std::size_t>(p * axis.taps + t)] * scale);
    }
  }
}

}  // namespace

double line_blur_variance(double pitch) { return 0.25 * fade_between(0.35, 0.5, pitch); }

AxisWeights axis_weights(std::span<const double> edges, std::array<double, 2> sigma_pixels,
                         double cells_a_pixel, bool swept) {
  const int pixels = static_cast<int>(edges.size()) - 1;
  AxisWeights axis;
  double widest = 0;
  for (std::size_t p = 0; p + 1 < edges.size(); ++p) {
    const double pitch = edges[p + 1] - edges[p];
    for (const double sigma : sigma_pixels) {
      widest = std::max(widest, profile_of(sigma, pitch, swept).radius());
    }
  }
  axis.taps = static_cast<int>(std::floor(2 * widest)) + 1;
  axis.pitch = whole_cache_lines<float>(pixels);
  for (int p = 0; p < axis.pitch; ++p) {
    const std::size_t at = static_cast<std::size_t>(std::min(p, pixels - 1));
    const double middle = 0.5 * (edges[at] + edges[at + 1]);
    axis.start.push_back(static_cast<int>(std::ceil(middle - widest - 0.5 - 1e-9)));
  }
  for (std::size_t basis = 0; basis < 2; ++basis) {
    fill_weights(axis, edges, basis, sigma_pixels[basis], cells_a_pixel, swept);
  }
  return axis;
}

}  // namespace kinescope
