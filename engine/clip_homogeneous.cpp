#include "engine/clip_homogeneous.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace kinescope {
namespace {

bool finite(const ClipVertex& v) {
  const glm::dvec4& p = v.position;
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

ClipVertex crossing(const ClipVertex& inside, double inside_by, const ClipVertex& outside,
                    double outside_by, int attribute_count) {
  const double t = inside_by / (inside_by - outside_by);
  ClipVertex v;
  v.position = inside.position + t * (outside.position - inside.position);
  for (std::size_t i = 0; i < static_cast<std::size_t>(attribute_count); ++i) {
    const double a = inside.attributes[i], b = outside.attributes[i];
    v.attributes[i] = static_cast<float>(a + t * (b - a));
  }
  return v;
}

}  // namespace

double ClipPlane::inside_by(const glm::dvec4& p) const { return glm::dot(normal, p) - least; }

std::array<ClipPlane, 6> view_volume_planes() {
  return {{{{1, 0, 0, 1}},
           {{-1, 0, 0, 1}},
           {{0, 1, 0, 1}},
           {{0, -1, 0, 1}},
           {{0, 0, 1, 0}},
           {{0, 0, -1, 1}}}};
}

void clip_against(const ClipPlane& plane, std::span<const ClipVertex> polygon, int attribute_count,
                  std::vector<ClipVertex>& clipped) {
  clipped.clear();
  if (polygon.empty()) return;
  const ClipVertex* last = &polygon.back();
  double last_by = plane.inside_by(last->position);
  for (const ClipVertex& next : polygon) {
    const double next_by = plane.inside_by(next.position);
    // A corner on the plane is inside, and is itself the crossing of its edges.
    if (last_by > 0.0 && next_by < 0.0) {
      clipped.push_back(crossing(*last, last_by, next, next_by, attribute_count));
    } else if (last_by < 0.0 && next_by > 0.0) {
      clipped.push_back(crossing(next, next_by, *last, last_by, attribute_count));
    }
    if (next_by >= 0.0) clipped.push_back(next);
    last = &next;
    last_by = next_by;
  }
}

std::span<const ClipVertex> PolygonClipper::clip(std::span<const ClipVertex> polygon,
                                                 std::span<const ClipPlane> planes,
                                                 int attribute_count) {
  to_.clear();
  if (polygon.size() < 3 || !std::all_of(polygon.begin(), polygon.end(), finite)) return {};
  from_.assign(polygon.begin(), polygon.end());
  for (const ClipPlane& plane : planes) {
    clip_against(plane, from_, attribute_count, to_);
    from_.swap(to_);
  }
  if (from_.size() < 3) from_.clear();
  return from_;
}

}  // namespace kinescope
