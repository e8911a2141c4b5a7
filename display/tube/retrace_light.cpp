#include "display/tube/retrace_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "display/decay.h"
#include "display/tube/deflection.h"
#include "display/tube/spot.h"

namespace kinescope {
namespace {

constexpr int kMiddleGun = 1;
constexpr int kPieces = 8;            // of a sweep
constexpr int kFlightPieces = 48;     // of a flight back, whose speed changes
constexpr double kWithin = 1e-3;      // clocks from a piece's ends, so that it lies in one phase
constexpr double kLeastLight = 1e-7;  // of a flight's whole light; less is left out

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
                           std::span<const Phosphor> laws, int width, int height)
    : scan_(settings.mode),
      current_(current),
      laws_(laws.begin(), laws.end()),
      width_(width),
      height_(height),
      cell_pixels_(static_cast<double>(width) * height * settings.deflection.width *
                   settings.deflection.height / settings.mode.horizontal.active /
                   settings.mode.vertical.active) {
  if (current > 0) follow_frame(settings);
}

void RetraceLight::follow_frame(const TubeSettings& settings) {
  const SpotModel spot(settings.spot);
  const PixelsAMm pixels = pixels_a_mm(settings.glass, width_, height_);
  const int lines = settings.mode.vertical.total();
  for (int line = 0; line < lines; ++line) follow_line(settings, line);
  for (Flight& flight : flights_) {
    flight.stroke.sigma = static_cast<float>(spot.sigma_mm(current_) * pixels.down);
  }
}

/// The line's sweep, its front porch and its flight back, each in pieces that are all but straight.
void RetraceLight::follow_line(const TubeSettings& settings, int line) {
  const Deflection deflection(settings.deflection, settings.glass, kMiddleGun);
  const Camera camera(settings.glass);
  const SyncTiming& h = settings.mode.horizontal;
  const double hz = settings.mode.pixel_clock_hz;
  const auto landing = [&](double clock) {
    const BeamPosition beam = scan_.at(Seconds(clock / hz));
    const Place glass = deflection.glass_of_sweep({2 * beam.x - 1, 2 * beam.y - 1});
    const Place at = picture_of_glass(camera, settings.glass, glass);
    return Place{0.5 * (at.x + 1) * width_, 0.5 * (at.y + 1) * height_};
  };
  const auto follow = [&](double begin, double length, int pieces) {
    const double step = length / pieces;
    for (int i = 0; i < pieces; ++i) {
      const double clock = begin + i * step;
      if (!scan_.at(Seconds((clock + 0.5 * step) / hz)).blanked) continue;
      const Place from = landing(clock + kWithin), to = landing(clock + step - kWithin);
      const auto as_float = [](double v) { return static_cast<float>(v); };
      flights_.push_back(
          {{as_float(from.x), as_float(from.y), as_float(to.x), as_float(to.y), 1}, clock, step});
    }
  };
  const double start = static_cast<double>(line) * h.total();
  follow(start, h.active, kPieces);
  if (h.front_porch > 0) follow(start + h.active, h.front_porch, 1);
  follow(start + h.active + h.front_porch, h.sync + h.back_porch, kFlightPieces);
}

/// What each flight leaves in the layers in [begin, end).
void RetraceLight::weigh(BeamTime begin, BeamTime end) {
  const double frame = to_clocks(scan_.frame_clocks()), hz = scan_.mode().pixel_clock_hz;
  const Periods whole = divide(end - begin, scan_.frame_clocks());
  const double first = to_clocks(divide(begin, scan_.frame_clocks()).rest);
  const double rest = to_clocks(whole.rest);
  strokes_.clear();
  weights_.clear();
  std::vector<double> light(laws_.size());
  for (const Flight& flight : flights_) {
    const double middle = flight.begin + 0.5 * flight.length;
    const double since = std::fmod(first - middle + 2 * frame, frame);
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      light[i] = static_cast<double>(whole.whole);
      for (const DecayTerm& term : laws_[i].terms) {
        light[i] += term.share * light_of_repeated(since, rest, frame, term.tau.count() * hz);
      }
    }
    if (*std::max_element(light.begin(), light.end()) < kLeastLight) continue;
    strokes_.push_back(flight.stroke);
    const double scale = current_ * cell_pixels_ * flight.length;
    for (const double l : light) weights_.push_back(static_cast<float>(l * scale));
  }
}

const LightOverlay& RetraceLight::light(BeamTime begin, BeamTime end, Workers& workers) {
  if (current_ <= 0) return overlay_;
  const bool even = divide(end - begin, scan_.frame_clocks()).rest == BeamTime();
  if (even && !overlay_.empty() && length_drawn_ == end - begin) return overlay_;
  length_drawn_ = even ? end - begin : BeamTime();
  weigh(begin, end);
  const int layers = static_cast<int>(laws_.size());
  if (tiles_.tiles() == 0) tiles_ = TiledLight(width_, height_, layers);
  tiles_.clear();
  painter_.draw(strokes_, weights_, tiles_, workers);
  overlay_.resize(laws_.size());
  for (std::vector<float>& plane : overlay_) {
    plane.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0f);
  }
  workers.run(tiles_.tiles(), [&](int tile, int) {
    if (!tiles_.lit(tile)) return;
    const BeamTile place = tiles_.tile(tile);
    const int columns = std::min(kBeamTile, width_ - place.x);
    const int rows = std::min(kBeamTile, height_ - place.y);
    for (int layer = 0; layer < layers; ++layer) {
      const float* from = tiles_.plane(tile, layer);
      float* to = overlay_[static_cast<std::size_t>(layer)].data() +
                  static_cast<std::ptrdiff_t>(place.y) * width_ + place.x;
      for (int y = 0; y < rows; ++y, from += kBeamTile, to += width_) {
        std::copy_n(from, columns, to);
      }
    }
  });
  return overlay_;
}

}  // namespace kinescope
