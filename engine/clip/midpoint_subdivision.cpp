#include "engine/clip/midpoint_subdivision.h"

#include <algorithm>
#include <cmath>

namespace kinescope {

MidpointSubdivision::MidpointSubdivision(const ClipWindow& window, const Segment2& line,
                                         double tolerance)
    : outer(line.from),
      inner(line.to),
      state(is_finite(line.from) && is_finite(line.to) ? ClipState::kRunning
                                                       : ClipState::kRejected),
      segment(line),
      window_(window),
      line_(line),
      tolerance_(tolerance) {}

bool MidpointSubdivision::found(const glm::dvec2& p) {
  (end == 0 ? segment.from : segment.to) = p;
  if (end == 1) {
    state = ClipState::kAccepted;
    return false;
  }
  end = 1;
  outer = line_.to;
  inner = segment.from;
  return true;
}

bool MidpointSubdivision::next() {
  if (state != ClipState::kRunning) return false;
  const Outcode code = outcode(window_, outer);
  if (code == 0) return found(outer);
  if ((code & outcode(window_, inner)) != 0) {
    state = ClipState::kRejected;
    return false;
  }
  middle = outer * 0.5 + inner * 0.5;
  ++halvings;
  const double left = std::max(std::abs(outer.x - inner.x), std::abs(outer.y - inner.y));
  if (middle == outer || middle == inner || left <= tolerance_) {
    if (window_.contains(inner)) return found(inner);
    state = ClipState::kRejected;
    return false;
  }
  // Where the outer half is not plainly outside, the line leaves the window at or before its
  // middle: nothing beyond can be nearer.
  rejected_half = (code & outcode(window_, middle)) != 0;
  (rejected_half ? outer : inner) = middle;
  return true;
}

std::optional<Segment2> clip_midpoint_subdivision(const ClipWindow& window, const Segment2& line,
                                                  double tolerance) {
  MidpointSubdivision clip(window, line, tolerance);
  while (clip.next()) {
  }
  if (clip.state != ClipState::kAccepted) return std::nullopt;
  return clip.segment;
}

}  // namespace kinescope
