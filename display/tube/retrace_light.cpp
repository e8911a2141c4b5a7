#include "display/tube/retrace_light.h"

#include <algorithm>
#include <cmath>

#include "display/decay.h"
#include "display/tube/video_signal.h"

namespace kinescope {
namespace {

constexpr double kWithin = 1e-3;       // clocks from a piece's ends, so that it lies in one phase
constexpr double kLeastLight = 1e-12;  // of a piece's whole light; less is left out

}  // namespace

double light_of_repeated(double since, double length, double period, double dwell, double tau) {
  // What is left of all periods before, when another dwell begins.
  const double before = left_after_dwell(dwell, tau) * decayed(period - dwell, tau).left /
                        one_minus_exp(period / tau);
  const auto from = [&](double begin, double end) {
    return light_of_dose(begin, end, dwell, tau) +
           before * decayed(begin, tau).left * one_minus_exp((end - begin) / tau);
  };
  if (since + length <= period) return from(since, since + length);
  return from(since, period) + from(0, since + length - period);
}

RetraceLight::RetraceLight(const TubeSettings& settings, const Gun& gun,
                           std::span<const Phosphor> laws, int width, int height)
    : scan_(settings.mode),
      laws_(laws.begin(), laws.end()),
      width_(width),
      height_(height),
      painter_(width, height) {
  if (!(gun.blanked_current(false) > 0)) return;
  const FlightPath path(settings, width, height);
  for (int line = 0; line < settings.mode.vertical.total(); ++line) {
    follow_line(path, gun, line);
  }
}

/// The line's sweep, its front porch and its flight back, each in pieces that are all but straight.
void RetraceLight::follow_line(const FlightPath& path, const Gun& gun, int line) {
  const SyncTiming& h = scan_.mode().horizontal;
  const double hz = scan_.mode().pixel_clock_hz;
  const auto sweep_at = [&](double clock) {
    const BeamPosition beam = scan_.at(Seconds(clock / hz));
    return Place{2 * beam.x - 1, 2 * beam.y - 1};
  };
  const auto follow = [&](double begin, double length) {
    const int pieces = flight_pieces(length);
    const double step = length / pieces;
    for (int i = 0; i < pieces; ++i) {
      const double clock = begin + i * step, middle = clock + 0.5 * step;
      if (!scan_.at(Seconds(middle / hz)).blanked) continue;
      const double current = gun.blanked_current(in_sync_tip(scan_.mode(), middle));
      if (!(current > 0)) continue;
      const Place from = sweep_at(clock + kWithin), to = sweep_at(clock + step - kWithin);
      flights_.push_back(
          {path.stroke(from, to, current), clock, step, current * path.cell_pixels() * step});
    }
  };
  const double start = static_cast<double>(line) * h.total();
  const double back = start + h.active + h.front_porch;
  follow(start, h.active);
  if (h.front_porch > 0) follow(start + h.active, h.front_porch);
  follow(back, h.sync);
  if (h.back_porch > 0) follow(back + h.sync, h.back_porch);
}

namespace {

/// The same of a term, for many excitations and one window: those that do not dwell on the window's
/// ends need but one exponential.
class TermInWindow {
 public:
  TermInWindow(const DecayTerm& term, double hz, double length, double period)
      : share_(term.share),
        tau_(term.tau.count() * hz),
        length_(length),
        period_(period),
        within_(one_minus_exp(length / tau_)),
        without_(one_minus_exp((period - length) / tau_)),
        whole_(one_minus_exp(period / tau_)) {}
  double light(double since, double dwell) {
    if (dwell_ != dwell) {
      dwell_ = dwell;
      left_ = left_after_dwell(dwell, tau_) / whole_;
    }
    const double until = since + length_ - period_;  // since it came again
    if (since >= dwell && until <= 0) {
      return share_ * left_ * decayed(since - dwell, tau_).left * within_;
    }
    if (since >= dwell && until >= dwell) {
      return share_ * (1 - left_ * decayed(until - dwell, tau_).left * without_);
    }
    return share_ * light_of_repeated(since, length_, period_, dwell, tau_);
  }

 private:
  double share_, tau_, length_, period_;
  double within_, without_, whole_;  // lost in the window, in the rest of a period, in all of it
  double dwell_ = 0, left_ = 0;      // by all excitations until the last one's end
};

}  // namespace

/// What each flight leaves in the layers in [begin, end).
void RetraceLight::weigh(BeamTime begin, BeamTime end) {
  const double frame = to_clocks(scan_.frame_clocks()), hz = scan_.mode().pixel_clock_hz;
  const Periods whole = divide(end - begin, scan_.frame_clocks());
  const double first = to_clocks(divide(begin, scan_.frame_clocks()).rest);
  const double rest = to_clocks(whole.rest);
  strokes_.clear();
  weights_.clear();
  std::vector<std::vector<TermInWindow>> terms(laws_.size());
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    for (const DecayTerm& term : laws_[i].terms) terms[i].emplace_back(term, hz, rest, frame);
  }
  std::vector<double> light(laws_.size());
  for (const Flight& flight : flights_) {
    const double since = std::fmod(first - flight.begin + frame, frame);
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      light[i] = static_cast<double>(whole.whole);
      for (TermInWindow& term : terms[i]) light[i] += term.light(since, flight.length);
    }
    if (*std::max_element(light.begin(), light.end()) < kLeastLight) continue;
    strokes_.push_back(flight.stroke);
    for (const double l : light) weights_.push_back(static_cast<float>(l * flight.dose));
  }
}

const LightOverlay& RetraceLight::light(BeamTime begin, BeamTime end, Workers& workers) {
  if (flights_.empty()) return overlay_;
  const bool even = divide(end - begin, scan_.frame_clocks()).rest == BeamTime();
  if (even && !overlay_.empty() && length_drawn_ == end - begin) return overlay_;
  length_drawn_ = even ? end - begin : BeamTime();
  weigh(begin, end);
  overlay_.resize(laws_.size());
  std::vector<FlightLight> lights;
  for (std::vector<float>& plane : overlay_) {
    plane.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0f);
    lights.push_back({{{{&plane, 1}}}});
  }
  painter_.add(strokes_, weights_, lights, workers);
  return overlay_;
}

}  // namespace kinescope
