#include "engine/io/crease_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <unordered_map>
#include <vector>

#include "engine/io/vertex_pool.h"
#include "engine/normals.h"

namespace kinescope {
namespace {

using Index = std::uint32_t;

std::vector<glm::vec3> facet_normals(const Mesh& mesh) {
  std::vector<glm::vec3> normals;
  normals.reserve(mesh.indices.size() / 3);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    normals.push_back(length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f));
  }
  return normals;
}

/// Which facets that share an edge are smooth across it.
struct Smoothness {
  std::vector<glm::vec3> facets;
  float cos_crease;
  std::span<const Index> groups;

  bool across(std::size_t a, std::size_t b) const {
    const float cosine = glm::dot(facets[a], facets[b]);
    if (groups.empty()) return cosine >= cos_crease;
    // Facets of one plane may share a vertex even where they are flat.
    return groups[a] == groups[b] && (groups[a] != 0 || cosine > 0.99999f);
  }
};

/// Corners joined into fans: those of one place that are smooth together. Source: Tarjan,
/// "Efficiency of a Good But Not Linear Set Union Algorithm", 1975, with path halving.
class Fans {
 public:
  explicit Fans(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  Index fan_of(Index corner) {
    while (parent_[corner] != corner) {
      parent_[corner] = parent_[parent_[corner]];
      corner = parent_[corner];
    }
    return corner;
  }
  void join(Index a, Index b) {
    // The lower number leads, so the order of joining does not show.
    const Index first = fan_of(a);
    const Index second = fan_of(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<Index> parent_;
};

/// One side of a triangle: its ends' places, in order, and the corners there.
struct Side {
  Index low_place, high_place;
  Index low_corner, high_corner;
};

std::vector<Side> sorted_sides(const Mesh& mesh, const std::vector<Index>& place) {
  std::vector<Side> sides;
  sides.reserve(mesh.indices.size());
  for (Index first = 0; first + 2 < mesh.indices.size(); first += 3) {
    for (Index i = 0; i < 3; ++i) {
      Index a = first + i;
      Index b = first + (i + 1) % 3;
      if (place[mesh.indices[a]] == place[mesh.indices[b]]) continue;
      if (place[mesh.indices[a]] > place[mesh.indices[b]]) std::swap(a, b);
      sides.push_back({place[mesh.indices[a]], place[mesh.indices[b]], a, b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.low_place != b.low_place) return a.low_place < b.low_place;
    if (a.high_place != b.high_place) return a.high_place < b.high_place;
    return a.low_corner < b.low_corner;
  });
  return sides;
}

Fans find_fans(const Mesh& mesh, const std::vector<Index>& place, const Smoothness& smooth) {
  Fans fans(mesh.indices.size());
  const std::vector<Side> sides = sorted_sides(mesh, place);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side& a = sides[i - 1];
    const Side& b = sides[i];
    if (a.low_place != b.low_place || a.high_place != b.high_place) continue;
    if (!smooth.across(a.low_corner / 3, b.low_corner / 3)) continue;
    fans.join(a.low_corner, b.low_corner);
    fans.join(a.high_corner, b.high_corner);
  }
  return fans;
}

Index doubled(Mesh& mesh, Index vertex) {
  mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
  if (!mesh.texcoords.empty()) mesh.texcoords.push_back(glm::vec2(mesh.texcoords[vertex]));
  if (!mesh.colours.empty()) mesh.colours.push_back(glm::vec3(mesh.colours[vertex]));
  return static_cast<Index>(mesh.positions.size() - 1);
}

/// Doubles vertices so that each belongs to one fan only. Triangles without area, which have no
/// direction, stay with any vertex of theirs.
void split_vertices(Mesh& mesh, const std::vector<Index>& fan_of_corner,
                    const std::vector<glm::vec3>& facets) {
  constexpr Index kNone = 0xffffffffu;
  std::vector<Index> first_fan(mesh.positions.size(), kNone);
  std::unordered_map<std::uint64_t, Index> doubles;  // of a vertex in its further fans
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    if (facets[corner / 3] == glm::vec3(0.0f)) continue;
    const Index vertex = mesh.indices[corner];
    const Index fan = fan_of_corner[corner];
    if (first_fan[vertex] == kNone) first_fan[vertex] = fan;
    if (first_fan[vertex] == fan) continue;
    const std::uint64_t key = std::uint64_t{vertex} << 32 | fan;
    const auto [entry, is_new] = doubles.try_emplace(key, kNone);
    if (is_new) entry->second = doubled(mesh, vertex);
    mesh.indices[corner] = entry->second;
  }
}

}  // namespace

void compute_crease_normals(Mesh& mesh, float crease_rad, std::span<const Index> groups) {
  VertexPool pool;
  std::vector<Index> place;
  place.reserve(mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) place.push_back(pool.index_of(position));

  const Smoothness smooth{facet_normals(mesh), std::cos(crease_rad), groups};
  Fans fans = find_fans(mesh, place, smooth);
  // A mesh with a vertex a fan: what lies on either side of a texture's seam is smooth together.
  Mesh fan_mesh;
  fan_mesh.positions.resize(mesh.indices.size());
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    fan_mesh.indices.push_back(fans.fan_of(static_cast<Index>(corner)));
    fan_mesh.positions[fan_mesh.indices.back()] = mesh.positions[mesh.indices[corner]];
  }
  compute_normals(fan_mesh);
  split_vertices(mesh, fan_mesh.indices, smooth.facets);
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    if (smooth.facets[corner / 3] == glm::vec3(0.0f)) continue;
    mesh.normals[mesh.indices[corner]] = fan_mesh.normals[fan_mesh.indices[corner]];
  }
}

}  // namespace kinescope
