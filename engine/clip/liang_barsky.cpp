#include "engine/clip/liang_barsky.h"

#include <algorithm>

namespace kinescope {

LiangBarsky::LiangBarsky(const ClipWindow& window, const Segment2& line)
    : state(is_finite(line.from) && is_finite(line.to) ? ClipState::kRunning
                                                       : ClipState::kRejected),
      window_(window),
      line_(line) {}

bool LiangBarsky::next() {
  if (state != ClipState::kRunning) return false;
  if (side == 3) {
    state = ClipState::kAccepted;
    return false;
  }
  ++side;
  const glm::dvec2 a = line_.from, d = line_.to - line_.from;
  switch (side) {
    case 0:
      p = -d.x, q = a.x - window_.min.x;
      break;
    case 1:
      p = d.x, q = window_.max.x - a.x;
      break;
    case 2:
      p = -d.y, q = a.y - window_.min.y;
      break;
    default:
      p = d.y, q = window_.max.y - a.y;
      break;
  }
  if (p < 0.0) enter = std::max(enter, q / p);
  if (p > 0.0) leave = std::min(leave, q / p);
  const bool beside = p == 0.0 && q < 0.0;
  if (beside || enter > leave) state = ClipState::kRejected;
  return state == ClipState::kRunning;
}

Segment2 LiangBarsky::segment() const {
  const glm::dvec2 d = line_.to - line_.from;
  return {enter > 0.0 ? line_.from + enter * d : line_.from,
          leave < 1.0 ? line_.from + leave * d : line_.to};
}

std::optional<Segment2> clip_liang_barsky(const ClipWindow& window, const Segment2& line) {
  LiangBarsky clip(window, line);
  while (clip.next()) {
  }
  if (clip.state != ClipState::kAccepted) return std::nullopt;
  return clip.segment();
}

}  // namespace kinescope
