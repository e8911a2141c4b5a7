#include "display/tube/retrace_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "display/decay.h"
#include "display/tube/deflection.h"
#include "display/tube/spot.h"

namespace kinescope {
namespace {

constexpr double kReach = 3.5;        // of a spot, deviations
constexpr double kMostPixels = 0.75;  // from one spot to the next

/// Inverts the camera along the ray from the picture's middle.
Place picture_of_glass(const Camera& camera, const GlassSettings& glass, Place place) {
  if (glass.curvature_mm <= 0) return place;
  double low = 0, high = 2;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    const Place seen = camera.glass_of_picture({place.x * middle, place.y * middle});
    (std::hypot(seen.x, seen.y) < std::hypot(place.x, place.y) ? low : high) = middle;
  }
  return {place.x * low, place.y * low};
}

}  // namespace

double light_of_repeated(double since, double length, double period, double tau) {
  const double whole = one_minus_exp(period / tau);
  const auto from = [&](double begin, double end) {
    const Decayed before = decayed(begin, tau);
    return before.left * one_minus_exp((end - begin) / tau) / whole;
  };
  if (since + length <= period) return from(since, since + length);
  return from(since, period) + from(0, since + length - period);
}

RetraceLight::RetraceLight(const TubeSettings& settings, double current,
                           std::span<const ScreenLayer> layers, std::span<const Phosphor> laws,
                           int width, int height)
    : settings_(settings),
      scan_(settings.mode),
      current_(current),
      layers_(layers.begin(), layers.end()),
      laws_(laws.begin(), laws.end()),
      width_(width),
      height_(height) {
  const SpotModel spot(settings.spot);
  const PixelsAMm pixels = pixels_a_mm(settings.glass, width, height);
  const auto with_pixel = [](double sigma) { return std::sqrt(sigma * sigma + 1.0 / 12); };
  across_pixels_ = with_pixel(spot.sigma_mm(current) * spot.astigmatism() * pixels.across);
  down_pixels_ = with_pixel(spot.sigma_mm(current) * pixels.down);
}

void RetraceLight::draw_spot(std::vector<float>& plane, double x, double y, float light) const {
  const auto range = [](double at, double reach, int count) {
    return std::pair(std::max(0, static_cast<int>(std::floor(at - reach))),
                     std::min(count, static_cast<int>(std::ceil(at + reach)) + 1));
  };
  const auto [left, right] = range(x - 0.5, kReach * across_pixels_, width_);
  const auto [top, bottom] = range(y - 0.5, kReach * down_pixels_, height_);
  if (left >= right || top >= bottom) return;
  const double peak = 1 / (2 * std::numbers::pi * across_pixels_ * down_pixels_);
  for (int row = top; row < bottom; ++row) {
    const double dy = (row + 0.5 - y) / down_pixels_;
    for (int column = left; column < right; ++column) {
      const double dx = (column + 0.5 - x) / across_pixels_;
      plane[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(column)] +=
          light * static_cast<float>(peak * std::exp(-0.5 * (dx * dx + dy * dy)));
    }
  }
}

/// Follows the beam through one frame, a part of a clock at a time, wherever it is blanked.
void RetraceLight::draw_layer(std::size_t layer, BeamTime begin, BeamTime end) {
  const Deflection deflection(settings_.deflection, settings_.glass, layers_[layer].gun);
  const Camera camera(settings_.glass);
  const VideoMode& mode = scan_.mode();
  const double frame = to_clocks(scan_.frame_clocks()), hz = mode.pixel_clock_hz;
  const Periods whole = divide(end - begin, scan_.frame_clocks());
  const double first = to_clocks(divide(begin, scan_.frame_clocks()).rest);
  const double rest = to_clocks(whole.rest);
  const double area = static_cast<double>(width_) * height_ * settings_.deflection.width *
                      settings_.deflection.height / mode.horizontal.active / mode.vertical.active;
  const std::int64_t count = static_cast<std::int64_t>(std::ceil(frame));
  const double clock_of_step = frame / static_cast<double>(count);
  const auto landing = [&](double clock) {
    const BeamPosition beam = scan_.at(Seconds(clock / hz));
    const Place glass = deflection.glass_of_sweep({2 * beam.x - 1, 2 * beam.y - 1});
    const Place at = picture_of_glass(camera, settings_.glass, glass);
    return Place{0.5 * (at.x + 1) * width_, 0.5 * (at.y + 1) * height_};
  };
  for (std::int64_t i = 0; i < count; ++i) {
    const double clock = (static_cast<double>(i) + 0.5) * clock_of_step;
    if (!scan_.at(Seconds(clock / hz)).blanked) continue;
    double light = static_cast<double>(whole.whole);
    const double since = std::fmod(first - clock + 2 * frame, frame);
    for (const DecayTerm& term : laws_[layer].terms) {
      light += term.share * light_of_repeated(since, rest, frame, term.tau.count() * hz);
    }
    light *= current_ * area * clock_of_step;
    // Close spots along the way that the beam flies in the step.
    const Place from = landing(clock - 0.5 * clock_of_step);
    const Place to = landing(clock + 0.499 * clock_of_step);
    const int spots = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / kMostPixels);
    for (int spot = 0; spot < spots; ++spot) {
      const double along = (spot + 0.5) / spots;
      draw_spot(overlay_[layer], from.x + along * (to.x - from.x), from.y + along * (to.y - from.y),
                static_cast<float>(light / spots));
    }
  }
}

const LightOverlay& RetraceLight::light(BeamTime begin, BeamTime end, Workers& workers) {
  if (current_ <= 0) return overlay_;
  const bool even = divide(end - begin, scan_.frame_clocks()).rest == BeamTime();
  if (even && !overlay_.empty() && length_drawn_ == end - begin) return overlay_;
  length_drawn_ = even ? end - begin : BeamTime();
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  overlay_.resize(layers_.size());
  workers.run(static_cast<int>(layers_.size()), [&](int layer, int) {
    overlay_[static_cast<std::size_t>(layer)].assign(pixels, 0.0f);
    draw_layer(static_cast<std::size_t>(layer), begin, end);
  });
  return overlay_;
}

}  // namespace kinescope
