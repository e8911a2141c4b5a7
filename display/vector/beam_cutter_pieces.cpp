// The pieces that a cut makes, and the rules that place their spots in time.
#include <algorithm>
#include <cmath>

#include "display/decay.h"
#include "display/vector/beam_cutter.h"
#include "display/vector/stroke_law.h"

namespace kinescope {
namespace {

/// How long a fade is. Its last spots are faint but narrow: fewer would show.
constexpr double kFadeTaus = 9;
constexpr int kFadeSpots = 6;

}  // namespace

float BeamCutter::mean_current(const BeamSpan& span, const State& from, const State& to) const {
  if (tau_ == 0 || from.current == span.aim) return span.aim;
  const double left = left_after_dwell(to.t - from.t, tau_);
  return span.aim + (from.current - span.aim) * static_cast<float>(left);
}

BeamCutter::Rule BeamCutter::rule_of(double length, int spots) const {
  const auto& quadrature = stroke_law::kQuadratures[static_cast<std::size_t>(spots - 1)];
  Rule rule;
  rule.length = length, rule.spots = spots;
  rule.share = quadrature.weight;
  std::array<double, Settling::kSteps> times{};
  for (std::size_t i = 0; i < BeamSpots::kMost; ++i) {
    times[i] = rule.time[i] = (0.5 + 0.5 * static_cast<double>(quadrature.at[i])) * length;
  }
  times.back() = length;
  rule.step = settling_.short_steps(times);
  rule.whole = rule.step.back();
  return rule;
}

BeamCutter::Pulse BeamCutter::rise_pulse() const {
  Pulse pulse;
  if (tau_ == 0) return pulse;
  pulse.rule = rule_of(kCoarseTaus * tau_, 4);
  pulse.mean = static_cast<float>(1 - left_after_dwell(kCoarseTaus, 1));
  for (std::size_t i = 0; i < 4; ++i) {
    const auto current = static_cast<float>(decayed(pulse.rule.time[i], tau_).lost);
    pulse.rule.share[i] *= current / pulse.mean;
    pulse.grown[i] = static_cast<float>(grown(current));
  }
  return pulse;
}

BeamCutter::Pulse BeamCutter::fade_pulse() const {
  Pulse pulse;
  if (tau_ == 0) return pulse;
  pulse.rule = rule_of(kFadeTaus * tau_, kFadeSpots);
  float sum = 0;
  for (std::size_t i = 0; i < kFadeSpots; ++i) {
    const auto current = static_cast<float>(std::exp(-pulse.rule.time[i] / tau_));
    sum += pulse.rule.share[i] *= current;
    pulse.grown[i] = static_cast<float>(grown(current));
  }
  for (float& share : pulse.rule.share) share /= sum;
  return pulse;
}

/// Of the real motion's mean place and way, and the current's tilt along it.
BeamPiece BeamCutter::even_piece(const BeamSpan& span, const State& from, const State& to) const {
  BeamPiece piece{from.t, to.t, mean_current(span, from, to)};
  const double time = to.t - from.t, middle = 0.5 * (from.t + to.t);
  const double x = span.x.at + span.x.speed * middle + settling_.mean_place(from.x, to.x, time);
  const double y = span.y.at + span.y.speed * middle + settling_.mean_place(from.y, to.y, time);
  const double dx = span.x.speed * time + to.x.place - from.x.place;
  const double dy = span.y.speed * time + to.y.place - from.y.place;
  const float rise = to.current - from.current;
  const double shift = static_cast<double>(rise / (12 * piece.current));
  piece.x = {x + (shift - 0.5) * dx, x + (shift + 0.5) * dx};
  piece.y = {y + (shift - 0.5) * dy, y + (shift + 0.5) * dy};
  piece.spread[0] = span.spread * static_cast<float>(grown(piece.current) * spread_at(x, y));
  return piece;
}

/// Places, and widths by them.
void BeamCutter::place_spots(const BeamSpan& span, const State& from, const Rule& rule,
                             BeamPiece& piece) const {
  piece.spots = rule.spots;
  const double x = span.x.at + span.x.speed * from.t, y = span.y.at + span.y.speed * from.t;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rule.spots); ++i) {
    const double rest_x = settling_.place_after(from.x, rule.step[i]);
    const double rest_y = settling_.place_after(from.y, rule.step[i]);
    piece.x[i] = x + span.x.speed * rule.time[i] + rest_x;
    piece.y[i] = y + span.y.speed * rule.time[i] + rest_y;
    piece.spread[i] = span.spread * static_cast<float>(spread_at(piece.x[i], piece.y[i]));
  }
}

BeamPiece BeamCutter::spots_piece(const BeamSpan& span, const State& from, const State& to,
                                  const Rule& rule, const Full& full) const {
  BeamPiece piece{from.t, to.t, mean_current(span, from, to)};
  place_spots(span, from, rule, piece);
  piece.share = rule.share;
  const auto spots = static_cast<std::size_t>(rule.spots);
  if (from.current == span.aim) {
    for (std::size_t i = 0; i < spots; ++i) piece.spread[i] *= static_cast<float>(full.grown);
    return piece;
  }
  float sum = 0;
  for (std::size_t i = 0; i < spots; ++i) {
    const float current = current_after(rule.time[i], from.current, span.aim, tau_);
    const double lacks = 1 - static_cast<double>(current / span.aim);
    // A power of what is nearly 1, by its series.
    const double grows =
        std::abs(lacks) < kCoarseChange && current > kLeastGrown
            ? full.grown * (1 - growth_ * lacks * (1 + 0.5 * (1 - growth_) * lacks))
            : grown(current);
    piece.spread[i] *= static_cast<float>(grows);
    sum += piece.share[i] *= current;
  }
  for (float& share : piece.share) share /= sum;
  return piece;
}

BeamPiece BeamCutter::pulse_piece(const BeamSpan& span, const State& from, const Pulse& pulse,
                                  const Full& full) const {
  BeamPiece piece{from.t, from.t + pulse.rule.length, pulse.mean * span.aim};
  place_spots(span, from, pulse.rule, piece);
  piece.share = pulse.rule.share;
  const auto full_grown = static_cast<float>(grown(full.current));
  for (std::size_t i = 0; i < static_cast<std::size_t>(piece.spots); ++i) {
    piece.spread[i] *= std::max(least_grown_, pulse.grown[i] * full_grown);
  }
  return piece;
}

}  // namespace kinescope
