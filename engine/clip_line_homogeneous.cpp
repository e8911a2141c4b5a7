#include "engine/clip_line_homogeneous.h"

#include <algorithm>
#include <cmath>

namespace kinescope {

bool clip_line(std::span<const ClipPlane> planes, glm::dvec4& a, glm::dvec4& b) {
  double enter = 0.0, leave = 1.0;
  for (const ClipPlane& plane : planes) {
    const double a_by = plane.inside_by(a), b_by = plane.inside_by(b);
    if (!std::isfinite(a_by) || !std::isfinite(b_by)) return false;
    if (a_by < 0.0 && b_by < 0.0) return false;
    if (a_by < 0.0) enter = std::max(enter, a_by / (a_by - b_by));
    if (b_by < 0.0) leave = std::min(leave, a_by / (a_by - b_by));
  }
  if (enter > leave) return false;
  const glm::dvec4 from = a, along = b - a;
  if (enter > 0.0) a = from + enter * along;
  if (leave < 1.0) b = from + leave * along;
  return true;
}

}  // namespace kinescope
