#include "display/vector/beam_dynamics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "display/vector/beam_cutter.h"

namespace kinescope {
namespace {

/// A current that is left when it is to be none, and no longer counts.
constexpr float kNoCurrent = 1e-4f;
constexpr Seconds kTick{1e-12};
constexpr Seconds kEver{std::numeric_limits<double>::infinity()};

BeamSpan span_of(const BeamMove& move) {
  const double length = (move.end - move.begin).count();
  BeamSpan span;
  span.at = move.begin;
  span.to = length;
  span.x = {move.x0, length > 0 ? (move.x1 - move.x0) / length : 0, {}};
  span.y = {move.y0, length > 0 ? (move.y1 - move.y0) / length : 0, {}};
  span.current = span.aim = move.intensity;
  span.colour = move.colour, span.spread = move.spread;
  return span;
}

}  // namespace

BeamDynamics::BeamDynamics(const VectorMachine& m)
    : ideal_(m.deflection_khz == 0 && m.slew_mm_us == 0 && m.intensity_mhz == 0 &&
             m.spot_growth == 0 && m.edge_spread == 0),
      current_tau_(current_tau(m)),
      settling_(deflection_law(m)),
      lag_(deflection_law(m).lag()),
      x_(deflection_law(m)),
      y_(deflection_law(m)) {}

double BeamDynamics::place_of(const DeflectionAxis& axis) const {
  const double t = (now_ - axes_from_).count();
  const AxisMotion& motion = axis.motion();
  return motion.at + motion.speed * t + settling_.after(motion.rest, settling_.step(t)).place;
}

/// Puts before the axes what is asked for now, and finds until when that holds.
void BeamDynamics::take_command() {
  const Seconds passed = now_ - axes_from_;
  const Settling::Step step = settling_.step(passed.count());
  x_.advance(passed, settling_, step);
  y_.advance(passed, settling_, step);
  axes_from_ = now_;
  axes_until_ = kEver;
  while (!commands_.empty() && commands_.front().end <= now_) {
    rest_x_ = commands_.front().x1, rest_y_ = commands_.front().y1;
    commands_.pop_front();
  }
  DeflectionCommand x{rest_x_, 0}, y{rest_y_, 0};
  if (!commands_.empty() && commands_.front().begin > now_) {
    axes_until_ = commands_.front().begin;
  } else if (!commands_.empty()) {
    const BeamMove& move = commands_.front();
    const double length = (move.end - move.begin).count(), t = (now_ - move.begin).count();
    x.speed = (move.x1 - move.x0) / length, y.speed = (move.y1 - move.y0) / length;
    x.at = move.x0 + x.speed * t, y.at = move.y0 + y.speed * t;
    axes_until_ = move.end;
  }
  axes_until_ =
      std::min({axes_until_, now_ + x_.follow(x, settling_), now_ + y_.follow(y, settling_)});
}

/// @param until brought forward to when the current changes @return what is asked for now
float BeamDynamics::take_current(Seconds& until) {
  while (!currents_.empty() && currents_.front().end + lag_ <= now_) currents_.pop_front();
  if (currents_.empty()) return 0;
  const BeamMove& move = currents_.front();
  const Seconds begin = move.begin + lag_;
  until = std::min(until, begin > now_ ? begin : move.end + lag_);
  if (begin > now_) return 0;
  lit_ = move;
  return move.intensity;
}

void BeamDynamics::add_span(Seconds end, float aim, std::vector<BeamSpan>& spans) const {
  BeamSpan span;
  span.at = axes_from_;
  span.from = (now_ - axes_from_).count(), span.to = (end - axes_from_).count();
  span.x = x_.motion(), span.y = y_.motion();
  span.current = current_, span.aim = aim;
  span.colour = lit_.colour, span.spread = lit_.spread;
  spans.push_back(span);
}

void BeamDynamics::follow(std::span<const BeamMove> moves, Seconds end,
                          std::vector<BeamSpan>& spans) {
  if (ideal_) {
    for (const BeamMove& move : moves) {
      if (move.intensity > 0) spans.push_back(span_of(move));
    }
    now_ = end;
    return;
  }
  for (const BeamMove& move : moves) {
    commands_.push_back(move);
    if (move.intensity > 0) currents_.push_back(move);
  }
  if (!moves.empty()) axes_until_ = now_;
  while (now_ < end) {
    if (now_ >= axes_until_) take_command();
    Seconds until = std::min(end, axes_until_);
    const float aim = take_current(until);
    const bool fades = aim == 0 && current_ > 0 && current_tau_ > 0;
    if (fades) {
      const auto whole = static_cast<double>(current_ / kNoCurrent);
      until = std::min(until, now_ + Seconds(current_tau_ * std::max(1e-3, std::log(whole))));
    }
    // Rounding must not stop the clock.
    until = std::max(until, std::min(end, now_ + std::max(kTick, now_ * 1e-15)));
    if (aim > 0 || fades) add_span(until, aim, spans);
    current_ = current_after((until - now_).count(), current_, aim, current_tau_);
    if (aim == 0 && current_ <= 1.01f * kNoCurrent) current_ = 0;
    now_ = until;
  }
}

void BeamDynamics::repeat(Seconds length) {
  now_ += length;
  axes_from_ += length;
  axes_until_ += length;
  for (std::deque<BeamMove>* const moves : {&commands_, &currents_}) {
    for (BeamMove& move : *moves) move.begin += length, move.end += length;
  }
}

bool BeamDynamics::carries_since(Seconds time) const {
  const auto began = [&](const BeamMove& move) { return move.begin < time && move.end > now_; };
  return std::any_of(commands_.begin(), commands_.end(), began) ||
         std::any_of(currents_.begin(), currents_.end(), began);
}

}  // namespace kinescope
