#include "engine/io/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace kinescope {
namespace {

using Points = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Twice the signed area of a triangle.
double area2(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return cross(b - a, c - a); }

/// Newell's normal: right for any polygon, planar or not. Source: Sutherland et al., 1974.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(glm::dvec3(corners[i]) - origin,
                      glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
  }
  return sum;
}

/// The polygon seen along its normal, counter-clockwise, with the largest component left out.
Points project(std::span<const glm::vec3> corners) {
  const glm::dvec3 normal = newell_normal(corners);
  const glm::dvec3 size = glm::abs(normal);
  int axis = size.x > size.y ? 0 : 1;
  if (size.z > size[axis]) axis = 2;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const bool flip = normal[axis] < 0.0;
  Points points;
  points.reserve(corners.size());
  for (const glm::vec3& corner : corners) {
    points.push_back(flip ? glm::dvec2(corner[v], corner[u]) : glm::dvec2(corner[u], corner[v]));
  }
  return points;
}

bool is_convex(const Points& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (area2(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0.0) return false;
  }
  return true;
}

/// Corners still to be cut off, in order.
class EarClipper {
 public:
  explicit EarClipper(const Points& points) : points_(points), left_(points.size()) {
    std::iota(left_.begin(), left_.end(), 0u);
  }

  void clip(std::vector<CornerTriple>& out) {
    std::size_t at = 0;
    std::size_t tried = 0;
    while (left_.size() > 3 && tried < left_.size()) {
      if (is_ear(at)) {
        out.push_back({before(at), left_[at], after(at)});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
        tried = 0;
      } else {
        ++tried;
        ++at;
      }
      if (at >= left_.size()) at = 0;
    }
    for (std::size_t i = 2; i < left_.size(); ++i)
      out.push_back({left_[0], left_[i - 1], left_[i]});
  }

 private:
  std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

  bool is_ear(std::size_t i) const {
    const glm::dvec2 a = points_[before(i)];
    const glm::dvec2 b = points_[left_[i]];
    const glm::dvec2 c = points_[after(i)];
    if (!(area2(a, b, c) > 0.0)) return false;
    return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t other) {
      const glm::dvec2 p = points_[other];
      if (p == a || p == b || p == c) return false;
      return area2(a, b, p) >= 0.0 && area2(b, c, p) >= 0.0 && area2(c, a, p) >= 0.0;
    });
  }

  const Points& points_;
  std::vector<std::uint32_t> left_;
};

}  // namespace

void triangulate(std::span<const glm::vec3> corners, std::vector<CornerTriple>& out) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  if (n > 3 && n <= kMaxEarCorners) {
    const Points points = project(corners);
    if (!is_convex(points)) {
      EarClipper(points).clip(out);
      return;
    }
  }
  for (std::uint32_t i = 2; i < n; ++i) out.push_back({0, i - 1, i});
}

std::size_t PolygonSink::add(std::span<const std::uint32_t> corners, std::size_t place) {
  if (corners.size() < 3) return 0;
  const std::size_t count = mesh_.positions.size();
  if (std::any_of(corners.begin(), corners.end(), [&](auto index) { return index >= count; })) {
    if (lost_++ == 0) first_lost_ = place;
    return 0;
  }
  if (corners.size() == 3) {
    mesh_.indices.insert(mesh_.indices.end(), corners.begin(), corners.end());
    return 1;
  }
  points_.clear();
  for (const std::uint32_t index : corners) points_.push_back(mesh_.positions[index]);
  triangles_.clear();
  triangulate(points_, triangles_);
  for (const CornerTriple& triangle : triangles_) {
    for (const std::uint32_t corner : triangle) mesh_.indices.push_back(corners[corner]);
  }
  return triangles_.size();
}

void PolygonSink::warn_of_lost() const {
  if (lost_ == 0) return;
  file_.warn("left out " + std::to_string(lost_) +
                 (lost_ == 1 ? " face that names a vertex" : " faces that name a vertex") +
                 " which is not there",
             place_name_ + " " + std::to_string(first_lost_));
}

}  // namespace kinescope
