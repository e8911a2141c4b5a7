#include "display/vector/beam_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "display/vector/stroke_law.h"

namespace kinescope {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();
/// An even stroke's places may differ by so much from the real ones, deviations: then its light
/// does by less than a thousandth of its peak.
constexpr double kMostSag = 2e-3;
/// Of an even stroke, share.
constexpr double kMostCurrentChange = 2e-3;
/// Even strokes shorter than so many deviations are dearer than spots.
constexpr double kLeastEvenWay = 5;
/// So far a few spots make a piece, deviations.
constexpr double kSpotsWay = stroke_law::kPartLength;
/// While the current changes by more than this share of the full one, but no more than
/// kCoarseChange, a piece lasts for so many time constants of it.
constexpr double kFineChange = 1e-3, kFineTaus = 16;
/// Of how far the beam would come from the middle of an even way, deviations times eight: one spot
/// shows less of it, two less than the other.
constexpr double kBendsLittle = 5e-3, kBends = 0.3;
/// What a current still lacks, and no longer counts.
constexpr float kNoChange = 1e-6f;
/// A rise is drawn by its rule if the beam goes no farther in it, and a fade in a time constant.
constexpr double kRiseWay = 2, kFadeWay = 0.6;
/// Pieces shorter than they might be by so much share their rule.
constexpr double kShortPiece = 0.8;
/// Of a piece: what is shorter is no piece.
constexpr double kSliver = 1e-6;
/// Pieces of so many to the screen's width share one width of the spot.
constexpr double kPiecesAcross = 32;

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

double units_a_mm(const VectorMachine& m) { return m.width / m.screen_mm; }

}  // namespace

DeflectionLaw deflection_law(const VectorMachine& m) {
  return {m.deflection_khz, m.damping, m.slew_mm_us * units_a_mm(m)};
}

double current_tau(const VectorMachine& m) {
  return m.intensity_mhz > 0 ? 1 / (2e6 * std::numbers::pi * m.intensity_mhz) : 0;
}

float current_after(double t, float current, float aim, double tau) {
  if (tau == 0) return aim;
  if (current == aim) return aim;
  return aim + (current - aim) * static_cast<float>(std::exp(-t / tau));
}

BeamCutter::BeamCutter(const VectorMachine& m)
    : width_(m.width),
      height_(m.height),
      sigma_(m.spot_sigma_mm * units_a_mm(m)),
      growth_(m.spot_growth),
      edge_spread_(m.edge_spread),
      tau_(current_tau(m)),
      settling_(deflection_law(m)),
      least_grown_(static_cast<float>(grown(kLeastGrown))),
      rise_(rise_pulse()),
      fade_(fade_pulse()) {}

double BeamCutter::grown(float current) const {
  if (growth_ == 0 || current == 1) return 1;
  return std::pow(static_cast<double>(std::max(current, kLeastGrown)), growth_);
}

double BeamCutter::spread_at(double x, double y) const {
  if (edge_spread_ == 0) return 1;
  const double right = 2 * x / width_ - 1, up = (2 * y - height_) / width_;
  return 1 + edge_spread_ * (right * right + up * up);
}

BeamCutter::State BeamCutter::at(const BeamSpan& span, double t) const {
  const Settling::Step step = settling_.step(t);
  return {t, settling_.after(span.x.rest, step), settling_.after(span.y.rest, step),
          current_after(t - span.from, span.current, span.aim, tau_)};
}

BeamCutter::State BeamCutter::carried_on(const BeamSpan& span, const State& state, double by,
                                         const Settling::Step& step) const {
  float current = state.current;
  if (current != span.aim) {
    current = current_after(by, current, span.aim, tau_);
    if (std::abs(current - span.aim) < kNoChange) current = span.aim;
  }
  return {state.t + by, settling_.after(state.x, step), settling_.after(state.y, step), current};
}

BeamCutter::Full BeamCutter::full_of(const BeamSpan& span) const {
  const float current = tau_ > 0 ? std::max(span.current, span.aim) : span.aim;
  const double settled = grown(span.aim);
  const double most = current == span.aim ? settled : grown(current);
  return {current, sigma_ * static_cast<double>(span.spread) * most, settled};
}

/// What the current still lacks, of the full one.
double BeamCutter::change(const BeamSpan& span, const State& state, const Full& full) const {
  return static_cast<double>(std::abs(span.aim - state.current) / full.current);
}

/// For how long the beam is even from now on.
double BeamCutter::even_length(const BeamSpan& span, const State& state, const Full& full,
                               double turns) const {
  double even = turns > 0 ? std::sqrt(8 * kMostSag * full.sigma / turns) : kEver;
  const double lacks = tau_ > 0 ? change(span, state, full) : 0;
  if (lacks > 0) even = std::min(even, kMostCurrentChange * tau_ / lacks);
  if (edge_spread_ > 0) {
    const double speed = length_of(span.x.speed + state.x.speed, span.y.speed + state.y.speed);
    even = std::min(even, width_ / kPiecesAcross / speed);
  }
  return even;
}

/// How far the beam goes: Simpson's rule over its speed, which follows from three derivatives.
double BeamCutter::way(const BeamSpan& span, const State& state, double time) const {
  const double ax = settling_.acceleration(state.x), ay = settling_.acceleration(state.y);
  const double jx = settling_.acceleration({state.x.speed, ax});
  const double jy = settling_.acceleration({state.y.speed, ay});
  const double vx = span.x.speed + state.x.speed, vy = span.y.speed + state.y.speed;
  const auto speed = [&](double t) {
    return length_of(vx + t * (ax + 0.5 * t * jx), vy + t * (ay + 0.5 * t * jy));
  };
  return time / 6 * (speed(0) + 4 * speed(0.5 * time) + speed(time));
}

/// For how long a few spots stand for the beam: as far as it goes a few deviations, its transients'
/// series holds, and its current changes smoothly.
BeamCutter::Reached BeamCutter::spots_length(const BeamSpan& span, const State& state,
                                             const Full& full, double longest) const {
  const double sigma = full.sigma * spread_at(span.x.at + span.x.speed * state.t + state.x.place,
                                              span.y.at + span.y.speed * state.t + state.y.place);
  double length = std::min(longest, settling_.short_time());
  const double lacks = tau_ > 0 ? change(span, state, full) : 0;
  if (lacks > kFineChange) {
    length = std::min(length, tau_ * (lacks > kCoarseChange ? kCoarseTaus : kFineTaus));
  }
  double goes = way(span, state, length) / sigma;
  for (int i = 0; i < 2 && goes > 1.02 * kSpotsWay; ++i) {
    length *= kSpotsWay / goes;
    goes = i == 0 ? way(span, state, length) / sigma : kSpotsWay;
  }
  return {length, goes};
}

/// By how far the beam goes, how much its way bends or its speed changes, and its current.
int BeamCutter::spots_for(double way, double turns, double lacks, double length,
                          const Full& full) const {
  const double bends = turns * length * length / full.sigma;
  const int spots = stroke_law::quadrature_for(static_cast<float>(way)).nodes;
  if (bends > kBends || lacks > kCoarseChange) return std::max(spots, 3);
  return bends > kBendsLittle ? std::max(spots, 2) : spots;
}

const BeamCutter::Pulse* BeamCutter::pulse_at(const BeamSpan& span, const State& state,
                                              const Full& full, double left) const {
  if (tau_ == 0) return nullptr;
  const bool rises = state.current == 0, fades = span.aim == 0;
  if (rises == fades) return nullptr;
  const Pulse& pulse = rises ? rise_ : fade_;
  if (left < pulse.rule.length || pulse.rule.length > settling_.short_time()) return nullptr;
  const double time = rises ? pulse.rule.length : tau_;
  const double most = (rises ? kRiseWay : kFadeWay) * full.sigma;
  return way(span, state, time) <= most ? &pulse : nullptr;
}

void BeamCutter::add_pulse(const BeamSpan& span, const Pulse& pulse, const Full& full, double to,
                           State& state, std::vector<BeamPiece>& pieces) const {
  BeamPiece piece = pulse_piece(span, state, pulse, full);
  if (&pulse == &fade_) {
    // All that is left of it.
    piece.to = to;
    piece.current = mean_current(span, state, {to, {}, {}, 0});
    state.t = to;
  } else {
    state = carried_on(span, state, pulse.rule.length, pulse.rule.whole);
  }
  pieces.push_back(piece);
}

void BeamCutter::add_even(const BeamSpan& span, double length, double to, State& state,
                          std::vector<BeamPiece>& pieces) const {
  State after = carried_on(span, state, length, settling_.step(length));
  if (to - after.t < kSliver * length) after.t = to;
  pieces.push_back(even_piece(span, state, after));
  state = after;
}

/// As long as the last piece if that may be, or a whole share of what is left.
void BeamCutter::add_spots(const BeamSpan& span, const Full& full, double turns, double to,
                           State& state, Rule& rule, std::vector<BeamPiece>& pieces) const {
  const double left = to - state.t, lacks = tau_ > 0 ? change(span, state, full) : 0;
  Reached most = spots_length(span, state, full, left);
  most.length = std::max(most.length, kSliver * left);  // however fast: time must go on
  const bool again = rule.length <= (1 + kSliver) * most.length &&
                     rule.length >= kShortPiece * most.length && left >= 2 * rule.length;
  const double length = again ? rule.length : left / std::ceil(left / most.length - kSliver);
  const int spots = spots_for(most.way * length / most.length, turns, lacks, length, full);
  if (spots != rule.spots || std::abs(length - rule.length) > kSliver * length) {
    rule = rule_of(length, spots);
  }
  State after = carried_on(span, state, rule.length, rule.whole);
  if (to - after.t < kSliver * length) after.t = to;
  pieces.push_back(spots_piece(span, state, after, rule, full));
  state = after;
}

void BeamCutter::cut(const BeamSpan& span, double from, double to,
                     std::vector<BeamPiece>& pieces) const {
  State state = at(span, from);
  const Full full = full_of(span);
  Rule rule;
  while (state.t < to) {
    const double left = to - state.t;
    if (const Pulse* const pulse = pulse_at(span, state, full, left)) {
      add_pulse(span, *pulse, full, to, state, pieces);
      continue;
    }
    const double turns = settling_.most_acceleration(state.x, state.y);
    const double even = even_length(span, state, full, turns);
    const double speed = length_of(span.x.speed + state.x.speed, span.y.speed + state.y.speed);
    if (even >= left || even * speed >= kLeastEvenWay * full.sigma) {
      add_even(span, std::min(even, left), to, state, pieces);
    } else {
      add_spots(span, full, turns, to, state, rule, pieces);
    }
  }
}

}  // namespace kinescope
