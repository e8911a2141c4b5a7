#include "display/vector/beam_dynamics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "display/decay.h"

namespace kinescope {
namespace {

// How an even piece may differ from the real motion of equal mean place, so that the light differs
// by less than a thousandth. Shorter than the spot, only its spread along the way tells:
constexpr double kMostSag = 0.1;  // of the way's middle, deviations
// Longer, places along it tell one by one:
constexpr double kMostFineSag = 2e-3;          // deviations
constexpr double kMostFineSpeedChange = 2e-3;  // share
constexpr double kMostCurrentChange = 2e-3, kMostShortCurrentChange = 0.2;
/// A current that is left when it is to be none, and no longer counts.
constexpr float kNoCurrent = 1e-4f;
constexpr double kMostPieces = 4096;
constexpr Seconds kTick{1e-12};
/// Pieces of so many to the screen's width share one width of the spot.
constexpr double kPiecesAcross = 32;
/// Fainter beams grow no sharper.
constexpr float kLeastGrown = 0.02f;

double units_a_mm(const VectorMachine& m) { return m.width / m.screen_mm; }

DeflectionLaw law_of(const VectorMachine& m) {
  return {m.deflection_khz, m.damping, m.slew_mm_us * units_a_mm(m)};
}

}  // namespace

BeamDynamics::BeamDynamics(const VectorMachine& m)
    : ideal_(m.deflection_khz == 0 && m.slew_mm_us == 0 && m.intensity_mhz == 0 &&
             m.spot_growth == 0 && m.edge_spread == 0),
      width_(m.width),
      height_(m.height),
      sigma_(m.spot_sigma_mm * units_a_mm(m)),
      growth_(m.spot_growth),
      edge_spread_(m.edge_spread),
      current_tau_(m.intensity_mhz > 0 ? 1 / (2e6 * std::numbers::pi * m.intensity_mhz) : 0),
      lag_(law_of(m).lag()),
      x_(law_of(m)),
      y_(law_of(m)) {}

/// Puts before the axes what is asked for now. @param until brought forward to when that changes
void BeamDynamics::take_command(Seconds& until) {
  while (!commands_.empty() && commands_.front().end <= now_) {
    rest_x_ = commands_.front().x1, rest_y_ = commands_.front().y1;
    commands_.pop_front();
  }
  DeflectionCommand x{rest_x_, 0}, y{rest_y_, 0};
  if (!commands_.empty() && commands_.front().begin > now_) {
    until = std::min(until, commands_.front().begin);
  } else if (!commands_.empty()) {
    const BeamMove& move = commands_.front();
    const double length = (move.end - move.begin).count(), t = (now_ - move.begin).count();
    x.speed = (move.x1 - move.x0) / length, y.speed = (move.y1 - move.y0) / length;
    x.at = move.x0 + x.speed * t, y.at = move.y0 + y.speed * t;
    until = std::min(until, move.end);
  }
  until = std::min({until, now_ + x_.follow(x), now_ + y_.follow(y)});
}

/// @return the current that is asked for now
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

float BeamDynamics::current_after(double t, float aim) const {
  if (current_tau_ == 0) return aim;
  return aim + (current_ - aim) * static_cast<float>(std::exp(-t / current_tau_));
}

float BeamDynamics::mean_current(double from, double to, float aim) const {
  if (current_tau_ == 0) return aim;
  const float left = static_cast<float>(left_after_dwell(to - from, current_tau_));
  return aim + (current_after(from, aim) - aim) * left;
}

/// Times the spot's width at the full current in the middle of the screen.
float BeamDynamics::spread_at(double x, double y, float current) const {
  double spread = static_cast<double>(lit_.spread);
  if (growth_ > 0) spread *= std::pow(std::max(current, kLeastGrown), growth_);
  const double right = 2 * x / width_ - 1, up = (2 * y - height_) / width_;
  return static_cast<float>(spread * (1 + edge_spread_ * (right * right + up * up)));
}

double BeamDynamics::piece_length(double t, double sigma, float aim) const {
  const double speed = std::hypot(x_.speed(t), y_.speed(t));
  const double turn = std::hypot(x_.most_acceleration(t), y_.most_acceleration(t));
  const double within_spot = sigma / speed;
  double length = 1e9;
  if (turn > 0) {
    const double fine =
        std::min(kMostFineSpeedChange * speed / turn, std::sqrt(8 * kMostFineSag * sigma / turn));
    length = std::min(std::sqrt(8 * kMostSag * sigma / turn), std::max(within_spot, fine));
  }
  const auto change = static_cast<double>(std::abs(aim - current_after(t, aim)));
  if (current_tau_ > 0 && change > 0) {
    const double coarse = std::min(0.5 * within_spot, kMostShortCurrentChange * current_tau_);
    length = std::min(length, std::max(coarse, kMostCurrentChange * current_tau_ / change));
  }
  if (edge_spread_ > 0) length = std::min(length, width_ / kPiecesAcross / speed);
  return length;
}

/// Cuts what the beam does from now on into even pieces.
void BeamDynamics::add_pieces(double length, float aim, std::vector<BeamMove>& pieces) {
  BeamMove piece = lit_;
  for (double from = 0; from < length;) {
    const double sigma = sigma_ * static_cast<double>(spread_at(x_.place(from), y_.place(from),
                                                                current_after(from, aim)));
    double step = std::max(piece_length(from, sigma, aim), length / kMostPieces);
    if (from + 1.5 * step > length) step = std::min(step, length - from);
    double to = from + step;
    if (length - to < 1e-6 * length) to = length;
    const double x = x_.mean_place(from, to), y = y_.mean_place(from, to);
    double dx = x_.place(to) - x_.place(from), dy = y_.place(to) - y_.place(from);
    piece.intensity = mean_current(from, to, aim);
    const float rise = current_after(to, aim) - current_after(from, aim);
    const double shift = static_cast<double>(rise / (12 * piece.intensity));
    piece.x0 = x + (shift - 0.5) * dx, piece.x1 = x + (shift + 0.5) * dx;
    piece.y0 = y + (shift - 0.5) * dy, piece.y1 = y + (shift + 0.5) * dy;
    piece.begin = now_ + Seconds(from), piece.end = now_ + Seconds(to);
    piece.spread = spread_at(x, y, piece.intensity);
    pieces.push_back(piece);
    from = to;
  }
}

void BeamDynamics::follow(std::span<const BeamMove> moves, Seconds end,
                          std::vector<BeamMove>& pieces) {
  if (ideal_) {
    pieces.insert(pieces.end(), moves.begin(), moves.end());
    now_ = end;
    return;
  }
  for (const BeamMove& move : moves) {
    commands_.push_back(move);
    if (move.intensity > 0) currents_.push_back(move);
  }
  while (now_ < end) {
    Seconds until = end;
    take_command(until);
    const float aim = take_current(until);
    const bool fades = aim == 0 && current_ > 0 && current_tau_ > 0;
    if (fades) {
      const auto whole = static_cast<double>(current_ / kNoCurrent);
      until = std::min(until, now_ + Seconds(current_tau_ * std::max(1e-3, std::log(whole))));
    }
    // Rounding must not stop the clock.
    until = std::max(until, std::min(end, now_ + std::max(kTick, now_ * 1e-15)));
    const Seconds length = until - now_;
    if (aim > 0 || fades) add_pieces(length.count(), aim, pieces);
    current_ = current_after(length.count(), aim);
    if (aim == 0 && current_ <= 1.01f * kNoCurrent) current_ = 0;
    x_.advance(length);
    y_.advance(length);
    now_ = until;
  }
}

void BeamDynamics::repeat(Seconds length) {
  now_ += length;
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
