#include "engine/teapot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "engine/bezier_patch.h"
#include "engine/framing.h"

namespace kinescope {
namespace {

using Vec = glm::dvec3;

BezierPatch random_patch(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  BezierPatch patch;
  for (auto& row : patch.point) {
    for (Vec& p : row) p = Vec(number(random), number(random), number(random));
  }
  return patch;
}

/// de Casteljau: lines of lines of lines.
Vec casteljau(std::array<Vec, 4> p, double t) {
  for (std::size_t left = 3; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  }
  return p[0];
}
Vec casteljau(const BezierPatch& patch, double u, double v) {
  std::array<Vec, 4> ends;
  for (std::size_t row = 0; row < 4; ++row) ends[row] = casteljau(patch.point[row], u);
  return casteljau(ends, v);
}

TEST(BezierPatch, AgreesWithDeCasteljau) {
  const BezierPatch patch = random_patch(1);
  constexpr double kStep = 1e-5;
  for (double u = 0.05; u < 1; u += 0.15) {
    for (double v = 0.05; v < 1; v += 0.15) {
      const PatchSample s = sample_patch(patch, u, v);
      EXPECT_LT(glm::distance(s.position, casteljau(patch, u, v)), 1e-14);
      const Vec du = (casteljau(patch, u + kStep, v) - casteljau(patch, u - kStep, v));
      const Vec dv = (casteljau(patch, u, v + kStep) - casteljau(patch, u, v - kStep));
      EXPECT_LT(glm::distance(s.du, du / (2 * kStep)), 1e-8);
      EXPECT_LT(glm::distance(s.dv, dv / (2 * kStep)), 1e-8);
      EXPECT_LT(glm::distance(s.normal, glm::normalize(glm::cross(du, dv))), 1e-6);
    }
  }
}

TEST(BezierPatch, PassesThroughItsCornersExactly) {
  const BezierPatch patch = random_patch(2);
  for (const int u : {0, 1}) {
    for (const int v : {0, 1}) {
      const Vec corner = patch.point[v ? 3 : 0][u ? 3 : 0];
      EXPECT_EQ(sample_patch(patch, u, v).position, corner);
    }
  }
}

// A side that shrinks to a point has the normal that its neighbourhood tends to.
TEST(BezierPatch, PoleNormalsAreLimits) {
  for (int side = 0; side < 4; ++side) {
    BezierPatch patch = random_patch(3);
    for (std::size_t i = 0; i < 4; ++i) {
      (side == 0   ? patch.point[0][i]
       : side == 1 ? patch.point[3][i]
       : side == 2 ? patch.point[i][0]
                   : patch.point[i][3]) = Vec(1, 2, 3);
    }
    constexpr double kNear = 1e-6;
    for (double along = 0; along <= 1; along += 0.125) {
      const double u = side < 2 ? along : side - 2, v = side < 2 ? side : along;
      const double u2 = side < 2 ? along : std::abs(u - kNear);
      const double v2 = side < 2 ? std::abs(v - kNear) : along;
      const Vec normal = sample_patch(patch, u, v).normal;
      EXPECT_LT(glm::distance(normal, sample_patch(patch, u2, v2).normal), 1e-4)
          << "side " << side << " at " << along;
    }
  }
}

TEST(BezierPatch, APointHasNoNormal) {
  EXPECT_EQ(sample_patch(BezierPatch{}, 0.5, 0.5).normal, Vec(0.0));
}

using Place = std::array<float, 3>;
Place place(const glm::vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }  // -0 is 0

/// Triangles joined where their corners lie in the same place, to the last bit.
struct Joined {
  std::map<Place, int> corners;
  std::map<std::pair<int, int>, int> directed_edges;
  int triangles = 0;

  explicit Joined(const Mesh& mesh) {
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3, ++triangles) {
      std::array<int, 3> c{};
      for (std::size_t i = 0; i < 3; ++i) {
        const Place p = place(mesh.positions[mesh.indices[t + i]]);
        c[i] = corners.try_emplace(p, static_cast<int>(corners.size())).first->second;
      }
      for (std::size_t i = 0; i < 3; ++i) ++directed_edges[{c[i], c[(i + 1) % 3]}];
    }
  }

  std::set<std::pair<int, int>> open_edges() const {
    std::set<std::pair<int, int>> open;
    for (const auto& [edge, count] : directed_edges) {
      if (!directed_edges.contains({edge.second, edge.first})) open.insert(edge);
    }
    return open;
  }
  int edges() const {
    const auto inner = directed_edges.size() - open_edges().size();
    return static_cast<int>(inner / 2 + open_edges().size());
  }
  int euler() const { return static_cast<int>(corners.size()) - edges() + triangles; }
};

/// Connected loops of edges.
int loops(const std::set<std::pair<int, int>>& edges) {
  std::map<int, int> next;
  for (const auto& [from, to] : edges) next[from] = to;
  EXPECT_EQ(next.size(), edges.size()) << "two open edges leave one corner";
  int count = 0;
  while (!next.empty()) {
    ++count;
    for (int at = next.begin()->first; next.contains(at);) {
      const int to = next[at];
      next.erase(at);
      at = to;
    }
  }
  return count;
}

TEST(Teapot, HasThirtyTwoPatches) {
  for (const int n : {1, 2, 3, 8}) {
    const Mesh mesh = teapot_mesh(n);
    // The tops of the knob and of the bottom are poles: a row of n quads in 8 patches is half lost.
    EXPECT_EQ(mesh.indices.size() / 3, static_cast<std::size_t>(64 * n * n - 8 * n));
    EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(32 * (n + 1) * (n + 1)));
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.texcoords.size(), mesh.positions.size());
  }
  EXPECT_EQ(teapot_mesh(0).indices.size(), teapot_mesh(1).indices.size());
}

TEST(Teapot, StandsUprightWithItsSpoutTowardsX) {
  const Mesh mesh = teapot_mesh(16);
  Bounds b;
  for (const glm::vec3& p : mesh.positions) b.add(p);
  EXPECT_FLOAT_EQ(b.min.y, 0.0f);
  EXPECT_FLOAT_EQ(b.max.y, 3.15f);
  EXPECT_FLOAT_EQ(b.min.x, -3.0f);   // the handle
  EXPECT_NEAR(b.max.x, 3.43, 0.01);  // the spout's lip
  EXPECT_NEAR(b.max.z, 2.0, 1e-3);
  EXPECT_FLOAT_EQ(b.min.z, -b.max.z);
}

// Open where the original is: a rim around the lid, the lid's edge, both ends of handle and spout;
// and nowhere else, with every inner edge shared by two triangles that agree on what is outside.
TEST(Teapot, IsWatertightWhereTheOriginalIs) {
  for (const int n : {3, 5, 12}) {
    const Joined joined(teapot_mesh(n));
    for (const auto& [edge, count] : joined.directed_edges) ASSERT_EQ(count, 1);
    EXPECT_EQ(loops(joined.open_edges()), 6);
    // Two discs (shell, lid: 1 each) and two tubes (0 each), less the one corner at (-2, 0.9, 0) in
    // which the handle's lower end touches the shell.
    EXPECT_EQ(joined.euler(), 1);
  }
}

TEST(Teapot, NormalsPointOutAsTheTrianglesDo) {
  for (const int n : {6, 16}) {
    const Mesh mesh = teapot_mesh(n);
    for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      const auto* i = &mesh.indices[t];
      const glm::vec3 a = mesh.positions[i[0]];
      const glm::vec3 face =
          glm::normalize(glm::cross(mesh.positions[i[1]] - a, mesh.positions[i[2]] - a));
      for (int c = 0; c < 3; ++c) {
        // Coarse triangles lean away from the surface, but never past a right angle.
        EXPECT_GT(glm::dot(face, mesh.normals[i[c]]), n > 10 ? 0.6f : 0.0f) << "triangle " << t / 3;
      }
    }
  }
}

TEST(Teapot, PolesLookUpAndDown) {
  const Mesh mesh = teapot_mesh(6);
  int top = 0, bottom = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    if (p.x != 0 || p.z != 0) continue;
    if (p.y == 3.15f) {
      EXPECT_LT(glm::distance(mesh.normals[v], glm::vec3(0, 1, 0)), 1e-6f);
      ++top;
    } else if (p.y == 0) {
      EXPECT_LT(glm::distance(mesh.normals[v], glm::vec3(0, -1, 0)), 1e-6f);
      ++bottom;
    }
  }
  EXPECT_EQ(top, 4 * 7);
  EXPECT_EQ(bottom, 4 * 7);
}

TEST(Teapot, BodyFacesAwayFromItsAxis) {
  const Mesh mesh = teapot_mesh(8);
  int checked = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v], n = mesh.normals[v];
    const glm::vec3 out(p.x, 0, p.z);
    // The body below its shoulder; handle and spout lie farther out or are thin.
    if (p.y < 0.3f || p.y > 2.0f || std::abs(p.z) < 0.8f) continue;
    EXPECT_GT(glm::dot(n, glm::normalize(out)), 0.5f);
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

TEST(Teapot, TextureRunsOnceAround) {
  const Mesh mesh = teapot_mesh(4);
  for (const glm::vec2& t : mesh.texcoords) {
    EXPECT_TRUE(t.x >= 0 && t.x <= 1 && t.y >= 0 && t.y <= 1);
  }
  // Never mirrored: seen from outside, v runs down where u runs right.
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const auto* i = &mesh.indices[t];
    const glm::vec2 a = mesh.texcoords[i[0]], b = mesh.texcoords[i[1]], c = mesh.texcoords[i[2]];
    EXPECT_LT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0.0f);
  }
}

}  // namespace
}  // namespace kinescope
