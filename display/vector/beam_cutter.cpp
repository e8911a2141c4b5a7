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
/// So far four spots make a piece, deviations (stroke_law.h).
constexpr double kSpotsWay = stroke_law::kPartLength;
/// While the current changes by more than the first, or the second, share of the greater one, a
/// piece lasts for so many time constants of it.
constexpr double kCoarseChange = 0.05, kFineChange = 1e-3;
constexpr double kCoarseTaus = 3, kFineTaus = 8;
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

/// Times the spot's width at the full current in the middle of the screen.
float BeamCutter::spread_at(const BeamSpan& span, double x, double y, float current) const {
  double spread = static_cast<double>(span.spread);
  if (growth_ > 0 && current != 1) spread *= std::pow(std::max(current, kLeastGrown), growth_);
  if (edge_spread_ > 0) {
    const double right = 2 * x / width_ - 1, up = (2 * y - height_) / width_;
    spread *= 1 + edge_spread_ * (right * right + up * up);
  }
  return static_cast<float>(spread);
}

BeamCutter::State BeamCutter::at(const BeamSpan& span, double t) const {
  const Settling::Step step = settling_.step(t);
  return {t, settling_.after(span.x.rest, step), settling_.after(span.y.rest, step),
          current_after(t - span.from, span.current, span.aim, tau_)};
}

BeamCutter::State BeamCutter::carried_on(const BeamSpan& span, const State& state, double by,
                                         bool is_short) const {
  const Settling::Step step = is_short ? settling_.short_step(by) : settling_.step(by);
  return {state.t + by, settling_.after(state.x, step), settling_.after(state.y, step),
          current_after(by, state.current, span.aim, tau_)};
}

float BeamCutter::mean_current(const BeamSpan& span, const State& from, const State& to) const {
  if (tau_ == 0 || from.current == span.aim) return span.aim;
  const double left = left_after_dwell(to.t - from.t, tau_);
  return span.aim + (from.current - span.aim) * static_cast<float>(left);
}

/// How the next piece is to be cut.
struct BeamCutter::Plan {
  double length;  // seconds
  int spots;      // 0: an even stroke
  bool is_short;  // within Settling::short_time()
};

BeamCutter::Plan BeamCutter::plan(const BeamSpan& span, const State& state, double left) const {
  const double speed_x = span.x.speed + state.x.speed, speed_y = span.y.speed + state.y.speed;
  const double speed = std::sqrt(speed_x * speed_x + speed_y * speed_y);
  const double turn_x = settling_.most_acceleration(state.x);
  const double turn_y = settling_.most_acceleration(state.y);
  const double turn = std::sqrt(turn_x * turn_x + turn_y * turn_y);
  const float most = std::max(state.current, span.aim);
  const auto change = static_cast<double>(std::abs(span.aim - state.current) / most);
  const double sigma = sigma_ * static_cast<double>(spread_at(
                                    span, span.x.at + span.x.speed * state.t + state.x.place,
                                    span.y.at + span.y.speed * state.t + state.y.place, most));
  double even = turn > 0 ? std::sqrt(8 * kMostSag * sigma / turn) : kEver;
  if (tau_ > 0 && change > 0) even = std::min(even, kMostCurrentChange * tau_ / change);
  if (edge_spread_ > 0) even = std::min(even, width_ / kPiecesAcross / speed);
  if (even >= left) return {left, 0, false};
  if (even * speed >= kLeastEvenWay * sigma) return {even, 0, false};
  // Later than now the speed is at most speed + turn t.
  const double way = kSpotsWay * sigma;
  double length = 2 * way / (speed + std::sqrt(speed * speed + 2 * turn * way));
  if (turn > 0) length = std::min(length, settling_.short_time());
  if (tau_ > 0 && change > kCoarseChange) {
    length = std::min(length, kCoarseTaus * tau_);
  } else if (tau_ > 0 && change > kFineChange) {
    length = std::min(length, kFineTaus * tau_);
  }
  if (length >= left) {
    length = left;
  } else if (2 * length > left) {
    length = 0.5 * left;
  }
  const auto deviations = static_cast<float>(length * (speed + 0.5 * turn * length) / sigma);
  int spots = stroke_law::quadrature_for(deviations).nodes;
  if (change > kCoarseChange) spots = std::max(spots, 3);
  return {length, spots, turn == 0 || length <= settling_.short_time()};
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
  piece.spread[0] = spread_at(span, x, y, piece.current);
  return piece;
}

BeamPiece BeamCutter::spots_piece(const BeamSpan& span, const State& from, const State& to,
                                  int spots) const {
  BeamPiece piece{from.t, to.t, mean_current(span, from, to), spots};
  const auto& rule = stroke_law::kQuadratures[static_cast<std::size_t>(spots - 1)];
  const double time = to.t - from.t;
  float sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(spots); ++i) {
    const double by = (0.5 + 0.5 * static_cast<double>(rule.at[i])) * time;
    const State node = carried_on(span, from, by, true);
    piece.x[i] = span.x.at + span.x.speed * node.t + node.x.place;
    piece.y[i] = span.y.at + span.y.speed * node.t + node.y.place;
    piece.spread[i] = spread_at(span, piece.x[i], piece.y[i], node.current);
    sum += piece.share[i] = rule.weight[i] * node.current;
  }
  for (float& share : piece.share) share /= sum;
  return piece;
}

void BeamCutter::cut(const BeamSpan& span, double from, double to,
                     std::vector<BeamPiece>& pieces) const {
  State state = at(span, from);
  while (state.t < to) {
    const Plan next = plan(span, state, to - state.t);
    State after = carried_on(span, state, next.length, next.is_short);
    if (to - after.t < 1e-6 * (to - from)) after.t = to;
    pieces.push_back(next.spots == 0 ? even_piece(span, state, after)
                                     : spots_piece(span, state, after, next.spots));
    state = after;
  }
}

}  // namespace kinescope
