#include "engine/clip/sutherland_hodgman.h"

#include <algorithm>

#include "engine/clip/orientation.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// The left of a -> b, as a plane of the homogeneous clipper. Along an axis it is exact.
ClipPlane left_of(const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 n(a.y - b.y, b.x - a.x);
  if (n.x == 0.0) return {{0, n.y > 0 ? 1 : -1, 0, n.y > 0 ? -a.y : a.y}};
  if (n.y == 0.0) return {{n.x > 0 ? 1 : -1, 0, 0, n.x > 0 ? -a.x : a.x}};
  return {{n.x, n.y, 0, -(n.x * a.x + n.y * a.y)}};
}

/// A new corner on an upright or level side lies on it to the bit.
glm::dvec2 on_side(glm::dvec2 p, const Segment2& side) {
  if (side.from.x == side.to.x) p.x = side.from.x;
  if (side.from.y == side.to.y) p.y = side.from.y;
  return p;
}

/// Counter-clockwise, without repeated corners and those in the middle of a side.
std::vector<glm::dvec2> tidy_convex(std::span<const glm::dvec2> corners) {
  std::vector<glm::dvec2> kept;
  int turn = 0;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_finite(corners[i])) throw_bad_input("a convex clip polygon needs finite corners");
    if (corners[i] == corners[(i + 1) % n]) continue;
    kept.push_back(corners[i]);
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const int here = orientation(kept[i], kept[(i + 1) % kept.size()], kept[(i + 2) % kept.size()]);
    if (here * turn < 0) throw_bad_input("the clip polygon is not convex");
    if (here != 0) turn = here;
  }
  if (turn == 0) throw_bad_input("the clip polygon has no area");
  if (turn < 0) std::reverse(kept.begin(), kept.end());
  return kept;
}

}  // namespace

SutherlandHodgman::SutherlandHodgman(const ClipWindow& window,
                                     std::span<const glm::dvec2> polygon) {
  const glm::dvec2 a = window.min, b = window.max;
  sides_ = {{{a.x, b.y}, a}, {{b.x, a.y}, b}, {a, {b.x, a.y}}, {b, {a.x, b.y}}};
  planes_ = {{{1, 0, 0, -a.x}}, {{-1, 0, 0, b.x}}, {{0, 1, 0, -a.y}}, {{0, -1, 0, b.y}}};
  start(polygon);
}

SutherlandHodgman::SutherlandHodgman(std::span<const glm::dvec2> convex,
                                     std::span<const glm::dvec2> polygon) {
  const std::vector<glm::dvec2> corners = tidy_convex(convex);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    sides_.push_back({a, b});
    planes_.push_back(left_of(a, b));
  }
  start(polygon);
}

void SutherlandHodgman::start(std::span<const glm::dvec2> polygon) {
  if (polygon.size() < 3 || !std::all_of(polygon.begin(), polygon.end(), is_finite)) return;
  polygon_.assign(polygon.begin(), polygon.end());
}

bool SutherlandHodgman::next() {
  if (stage_ == stages()) return false;
  const auto k = static_cast<std::size_t>(stage_++);
  from_.clear();
  for (const glm::dvec2& p : polygon_) {
    ClipVertex v;
    v.position = {p, 0.0, 1.0};
    v.corner = 0;  // an old one
    from_.push_back(v);
  }
  clip_against(planes_[k], from_, 0, to_);
  polygon_.clear();
  for (const ClipVertex& v : to_) {
    const glm::dvec2 p(v.position);
    polygon_.push_back(v.corner < 0 ? on_side(p, sides_[k]) : p);
  }
  if (polygon_.size() < 3) polygon_.clear();
  return true;
}

std::vector<ClippedEdge> SutherlandHodgman::edges(int k,
                                                  std::span<const glm::dvec2> polygon) const {
  const ClipPlane& plane = planes_[static_cast<std::size_t>(k)];
  const auto inside_by = [&](const glm::dvec2& p) { return plane.inside_by({p, 0.0, 1.0}); };
  std::vector<ClippedEdge> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &from = polygon[(i + polygon.size() - 1) % polygon.size()], &to = polygon[i];
    const double from_by = inside_by(from), to_by = inside_by(to);
    ClippedEdge edge{from, to};
    if (from_by >= 0.0 && to_by < 0.0) edge.what = EdgeCase::kLeaving;
    if (from_by < 0.0) edge.what = to_by < 0.0 ? EdgeCase::kOutside : EdgeCase::kEntering;
    edge.handed_on =
        int(to_by >= 0.0) + int(std::min(from_by, to_by) < 0.0 && std::max(from_by, to_by) > 0.0);
    edges.push_back(edge);
  }
  return edges;
}

std::vector<glm::dvec2> clip_polygon(const ClipWindow& window,
                                     std::span<const glm::dvec2> polygon) {
  SutherlandHodgman clip(window, polygon);
  while (clip.next()) {
  }
  return clip.polygon();
}

std::vector<glm::dvec2> clip_polygon(std::span<const glm::dvec2> convex,
                                     std::span<const glm::dvec2> polygon) {
  SutherlandHodgman clip(convex, polygon);
  while (clip.next()) {
  }
  return clip.polygon();
}

}  // namespace kinescope
