#include "engine/clip/cohen_sutherland.h"

namespace kinescope {
namespace {

/// Where the whole line meets a side. From the line's own ends, so that errors do not add up.
glm::dvec2 crossing(const ClipWindow& window, const Segment2& line, Outcode side) {
  const glm::dvec2 a = line.from, d = line.to - line.from;
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
  (moved_from ? segment.from : segment.to) = crossing(window_, line_, side);
  (moved_from ? from_code : to_code) = outcode(window_, moved_from ? segment.from : segment.to);
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
