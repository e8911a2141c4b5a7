#include "display/vector/beam_pen.h"

#include <algorithm>
#include <cmath>

namespace kinescope {

std::optional<BeamPenSight> see(const BeamPen& pen, const BeamMove& move) {
  if (!(move.intensity > 0)) return std::nullopt;
  const double dx = move.x1 - move.x0, dy = move.y1 - move.y0;
  const double px = move.x0 - pen.x, py = move.y0 - pen.y;
  // |p + t d|^2 <= r^2
  const double a = dx * dx + dy * dy, b = px * dx + py * dy;
  const double c = px * px + py * py - pen.radius * pen.radius;
  double enter = 0, leave = 1;
  if (a > 0) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    enter = std::max(0.0, (-b - root) / a);
    leave = std::min(1.0, (-b + root) / a);
    if (leave < enter) return std::nullopt;
  } else if (c > 0) {
    return std::nullopt;
  }
  const Seconds length = move.end - move.begin;
  const Seconds needed = microseconds(pen.threshold_us) / static_cast<double>(move.intensity);
  if (length * (leave - enter) < needed) return std::nullopt;
  const double t = length.count() > 0 ? enter + needed / length : enter;
  return BeamPenSight{move.begin + length * t, move.x0 + t * dx, move.y0 + t * dy};
}

}  // namespace kinescope
