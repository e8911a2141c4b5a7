#include "engine/clip/cohen_sutherland.h"

namespace kinescope {
namespace {

/// Where a line through the outer end meets a side. Along the whole line's direction, so that
/// errors do not add up; from the end that moves, so that a second cut never takes it back outside.
glm::dvec2 crossing(const ClipWindow& window, const glm::dvec2& a, const glm::dvec2& d,
                    Outcode side) {
  if (side == kOutAbove || side == kOutBelow) {
    const double y = side == kOutAbove ? window.max.y : window.min.y;
    return {a.x + d.x * ((y - a.y) / d.y), y};
  }
  const double x = side == kOutRight ? window.max.x : window.min.x;
  return {x, a.y + d.y * ((x - a.x) / d.x)};
}

}  // namespace

CohenSutherland::CohenSutherland(const ClipWindow& window, const Segment2& line)
    : segment(line),
      from_code(outcode(window, line.from)),
      to_code(outcode(window, line.to)),
      state(is_finite(line.from) && is_finite(line.to) ? ClipState::kRunning
                                                       : ClipState::kRejected),
      window_(window),
      line_(line) {}

bool CohenSutherland::next() {
  if (state != ClipState::kRunning) return false;
  side = 0;
  if ((from_code | to_code) == 0) {
    state = ClipState::kAccepted;
    return false;
  }
  // Each end meets at most two sides; more is a window turned inside out.
  if ((from_code & to_code) != 0 || steps == 4) {
    state = ClipState::kRejected;
    return false;
  }
  moved_from = from_code != 0;
  const Outcode code = moved_from ? from_code : to_code;
  for (const Outcode s : {kOutAbove, kOutBelow, kOutRight, kOutLeft}) {
    if ((code & s) != 0) {
      side = s;
      break;
    }
  }
  glm::dvec2& end = moved_from ? segment.from : segment.to;
  end = crossing(window_, end, line_.to - line_.from, side);
  (moved_from ? from_code : to_code) = outcode(window_, end);
  ++steps;
  return true;
}

std::optional<Segment2> clip_cohen_sutherland(const ClipWindow& window, const Segment2& line) {
  CohenSutherland clip(window, line);
  while (clip.next()) {
  }
  if (clip.state != ClipState::kAccepted) return std::nullopt;
  return clip.segment;
}

}  // namespace kinescope
