#include "display/vector/beam_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "display/decay.h"
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
/// While the current changes by more than the first, or the second, share of the full one, a piece
/// lasts for so many time constants of it.
constexpr double kCoarseChange = 0.05, kFineChange = 1e-3;
constexpr double kCoarseTaus = 3, kFineTaus = 16;
constexpr int kLeastSpots = 3;
/// What a current still lacks, and no longer counts.
constexpr float kNoChange = 1e-6f;
/// Pieces shorter than they might be by so much share their steps.
constexpr double kShortPiece = 0.8;
/// Pieces of so many to the screen's width share one width of the spot.
constexpr double kPiecesAcross = 32;
/// Fainter beams grow no sharper.
constexpr float kLeastGrown = 0.02f;

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
      settling_(deflection_law(m)) {}

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

float BeamCutter::mean_current(const BeamSpan& span, const State& from, const State& to) const {
  if (tau_ == 0 || from.current == span.aim) return span.aim;
  const double left = left_after_dwell(to.t - from.t, tau_);
  return span.aim + (from.current - span.aim) * static_cast<float>(left);
}

/// For how long a few spots stand for the beam: as far as it goes a few deviations, its transients'
/// series holds, and its current changes smoothly.
double BeamCutter::spots_length(const BeamSpan& span, const State& state, double sigma,
                                double change) const {
  const double way = kSpotsWay * sigma;
  const double vx = span.x.speed + state.x.speed, vy = span.y.speed + state.y.speed;
  const double speed = std::sqrt(vx * vx + vy * vy);
  double length = std::min(settling_.short_time(), way / std::max(speed, 1e-30));
  if (tau_ > 0 && change > kFineChange) {
    length = std::min(length, tau_ * (change > kCoarseChange ? kCoarseTaus : kFineTaus));
  }
  // It may be faster in the end.
  const double end_x = vx + settling_.acceleration(state.x) * length;
  const double end_y = vy + settling_.acceleration(state.y) * length;
  return std::min(length, way / std::max(1e-30, std::sqrt(end_x * end_x + end_y * end_y)));
}

BeamCutter::Plan BeamCutter::plan(const BeamSpan& span, const State& state, double left) const {
  const double vx = span.x.speed + state.x.speed, vy = span.y.speed + state.y.speed;
  const double speed = std::sqrt(vx * vx + vy * vy);
  const double turn_x = settling_.most_acceleration(state.x);
  const double turn_y = settling_.most_acceleration(state.y);
  const double turn = std::sqrt(turn_x * turn_x + turn_y * turn_y);
  const float full = std::max(span.current, span.aim);
  const auto change = static_cast<double>(std::abs(span.aim - state.current) / full);
  const double sigma = sigma_ * static_cast<double>(span.spread) * grown(full) *
                       spread_at(span.x.at + span.x.speed * state.t + state.x.place,
                                 span.y.at + span.y.speed * state.t + state.y.place);
  double even = turn > 0 ? std::sqrt(8 * kMostSag * sigma / turn) : kEver;
  if (tau_ > 0 && change > 0) even = std::min(even, kMostCurrentChange * tau_ / change);
  if (edge_spread_ > 0) even = std::min(even, width_ / kPiecesAcross / speed);
  if (even >= left || even * speed >= kLeastEvenWay * sigma) {
    return {std::min(even, left), 0, true, 0};
  }
  const double length = std::min(left, spots_length(span, state, sigma, change));
  const double faster = speed + 0.5 * turn * length;
  return {length, std::min(faster * length / sigma, kSpotsWay), false,
          change > kCoarseChange ? kLeastSpots : 1};
}

void BeamCutter::make_steps(double length, int spots, Steps& steps) const {
  steps.length = length, steps.spots = spots;
  const auto& rule = stroke_law::kQuadratures[static_cast<std::size_t>(spots - 1)];
  for (std::size_t i = 0; i < static_cast<std::size_t>(spots); ++i) {
    const double share = 0.5 + 0.5 * static_cast<double>(rule.at[i]);
    steps.node[i] = settling_.short_step(share * length);
  }
  steps.whole = settling_.short_step(length);
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

BeamPiece BeamCutter::spots_piece(const BeamSpan& span, const State& from, const State& to,
                                  const Steps& steps) const {
  BeamPiece piece{from.t, to.t, mean_current(span, from, to), steps.spots};
  const auto& rule = stroke_law::kQuadratures[static_cast<std::size_t>(steps.spots - 1)];
  const bool changes = from.current != span.aim;
  const double width = static_cast<double>(span.spread) * (changes ? 1 : grown(span.aim));
  float sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(steps.spots); ++i) {
    const double by = (0.5 + 0.5 * static_cast<double>(rule.at[i])) * (to.t - from.t);
    const State node = carried_on(span, from, by, steps.node[i]);
    piece.x[i] = span.x.at + span.x.speed * node.t + node.x.place;
    piece.y[i] = span.y.at + span.y.speed * node.t + node.y.place;
    piece.spread[i] = static_cast<float>(width * (changes ? grown(node.current) : 1) *
                                         spread_at(piece.x[i], piece.y[i]));
    sum += piece.share[i] = changes ? rule.weight[i] * node.current : rule.weight[i];
  }
  if (!changes) return piece;
  for (float& share : piece.share) share /= sum;
  return piece;
}

void BeamCutter::cut(const BeamSpan& span, double from, double to,
                     std::vector<BeamPiece>& pieces) const {
  State state = at(span, from);
  Steps steps;
  const double sliver = 1e-6 * (to - from);
  while (state.t < to) {
    const double left = to - state.t;
    const Plan next = plan(span, state, left);
    if (next.even) {
      State after = carried_on(span, state, next.length, settling_.step(next.length));
      if (to - after.t < sliver) after.t = to;
      pieces.push_back(even_piece(span, state, after));
      state = after;
      continue;
    }
    // As long as the last one if that may be, or a whole share of what is left.
    const int spots =
        std::max(next.least_spots, stroke_law::quadrature_for(static_cast<float>(next.way)).nodes);
    const bool again = spots == steps.spots && steps.length <= next.length + sliver &&
                       steps.length >= kShortPiece * next.length && left >= 2 * steps.length;
    const double length = again ? steps.length : left / std::ceil(left / next.length - 1e-6);
    if (spots != steps.spots || std::abs(length - steps.length) > sliver) {
      make_steps(length, spots, steps);
    }
    State after = carried_on(span, state, length, steps.whole);
    if (to - after.t < sliver) after.t = to;
    pieces.push_back(spots_piece(span, state, after, steps));
    state = after;
  }
}

}  // namespace kinescope
