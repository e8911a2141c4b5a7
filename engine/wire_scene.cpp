#include "engine/wire_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <numeric>

namespace kinescope {
namespace {

constexpr float kFarthest = 1e18f;

using Triangle = std::array<glm::vec3, 3>;

bool usable(const glm::vec3& p) {
  const float farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::isfinite(p.x + p.y + p.z) && farthest <= kFarthest;
}

/// Corners of all triangles, in world space, three a triangle.
std::vector<glm::vec3> world_corners(const Scene& scene) {
  std::vector<glm::vec3> corners;
  const std::vector<glm::mat4> transforms = world_transforms(scene);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    for (const int m : scene.nodes[n].meshes) {
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
          // -0 becomes 0, so that equal places are equal bits.
          triangle[k] =
              glm::vec3(transforms[n] * glm::vec4(mesh.positions[mesh.indices[i + k]], 1)) + 0.0f;
        }
        if (!std::all_of(triangle.begin(), triangle.end(), usable)) continue;
        corners.insert(corners.end(), triangle.begin(), triangle.end());
      }
    }
  }
  return corners;
}

/// Gives each corner its point; points are in the order in which they first occur.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& corners,
                                std::vector<glm::dvec3>& points) {
  std::vector<std::uint32_t> order(corners.size()), point(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::array{corners[i].x, corners[i].y, corners[i].z};
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  std::vector<std::uint32_t> first(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (first[i] == i) {
      point[i] = static_cast<std::uint32_t>(points.size());
      points.emplace_back(corners[i]);
    } else {
      point[i] = point[first[i]];
    }
  }
  return point;
}

/// An edge as one triangle has it.
struct Side {
  std::uint32_t a, b;
  int face;  ///< none: the triangle has no area
  bool operator<(const Side& other) const {
    return std::array{a, b} != std::array{other.a, other.b}
               ? std::array{a, b} < std::array{other.a, other.b}
               : face < other.face;
  }
};

/// The way from an edge's line to a face's third corner, across the line.
glm::dvec3 across(const WireScene& scene, const WireEdge& edge, int face) {
  const glm::dvec3 from = scene.points[edge.a];
  const glm::dvec3 along = glm::normalize(scene.points[edge.b] - from);
  for (const std::uint32_t corner : scene.faces[static_cast<std::size_t>(face)]) {
    if (corner == edge.a || corner == edge.b) continue;
    const glm::dvec3 way = scene.points[corner] - from;
    return way - along * glm::dot(way, along);
  }
  return glm::dvec3(0);
}

float bend_of(const WireScene& scene, const WireEdge& edge, std::size_t faces) {
  if (faces != 2) return std::numbers::pi_v<float>;
  const glm::dvec3 one = across(scene, edge, edge.faces[0]);
  const glm::dvec3 other = -across(scene, edge, edge.faces[1]);
  return static_cast<float>(std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other)));
}

void join_sides(WireScene& scene, std::vector<Side> sides) {
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    WireEdge edge{sides[i].a, sides[i].b, {WireEdge::kNone, WireEdge::kNone}, 0};
    std::size_t faces = 0;
    for (; i < sides.size() && sides[i].a == edge.a && sides[i].b == edge.b; ++i) {
      if (sides[i].face == WireEdge::kNone) continue;
      if (faces < 2) edge.faces[faces] = sides[i].face;
      ++faces;
    }
    edge.bend_rad = bend_of(scene, edge, faces);
    scene.edges.push_back(edge);
  }
}

bool has_area(const WireScene& scene, const std::array<std::uint32_t, 3>& t) {
  const glm::dvec3 a = scene.points[t[0]];
  const glm::dvec3 normal = glm::cross(scene.points[t[1]] - a, scene.points[t[2]] - a);
  return glm::dot(normal, normal) > 0;
}

}  // namespace

WireScene wire_scene(const Scene& scene) {
  WireScene wire;
  const std::vector<std::uint32_t> point = weld(world_corners(scene), wire.points);
  std::vector<Side> sides;
  sides.reserve(point.size());
  for (std::size_t i = 0; i + 2 < point.size(); i += 3) {
    const std::array<std::uint32_t, 3> t{point[i], point[i + 1], point[i + 2]};
    const bool is_face = has_area(wire, t);
    const int face = is_face ? static_cast<int>(wire.faces.size()) : WireEdge::kNone;
    if (is_face) wire.faces.push_back(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      if (from != to) sides.push_back({std::min(from, to), std::max(from, to), face});
    }
  }
  join_sides(wire, std::move(sides));
  return wire;
}

}  // namespace kinescope
