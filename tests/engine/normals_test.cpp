#include "engine/normals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace kinescope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A cube of corners (+-1, +-1, +-1); bit f of `split` chooses face f's diagonal.
Mesh cube(unsigned split) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  // Counter-clockwise from outside.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
  for (unsigned f = 0; f < 6; ++f) {
    const std::size_t turn = (split >> f) & 1u;
    const auto at = [&](std::size_t i) { return kFaces[f][(i + turn) % 4]; };
    for (const std::size_t i : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(at(i));
  }
  return mesh;
}

TEST(Normals, CubeCornersDoNotDependOnTheDiagonals) {
  for (unsigned split = 0; split < 64; ++split) {
    Mesh mesh = cube(split);
    compute_normals(mesh);
    for (std::size_t v = 0; v < 8; ++v) {
      const glm::vec3 diagonal = glm::normalize(mesh.positions[v]);
      EXPECT_LT(glm::distance(mesh.normals[v], diagonal), 1e-6f) << "split " << split;
    }
  }
}

TEST(Normals, PointOutOfASphere) {
  Mesh mesh;
  constexpr std::uint32_t kRows = 24, kColumns = 48;
  for (std::uint32_t r = 0; r <= kRows; ++r) {
    for (std::uint32_t c = 0; c < kColumns; ++c) {
      const double a = 3.14159265358979 * r / kRows, b = 2 * 3.14159265358979 * c / kColumns;
      mesh.positions.emplace_back(std::sin(a) * std::cos(b), std::cos(a),
                                  -std::sin(a) * std::sin(b));
      if (r == kRows) continue;
      const std::uint32_t i = r * kColumns + c, j = r * kColumns + (c + 1) % kColumns;
      mesh.indices.insert(mesh.indices.end(), {i, i + kColumns, j + kColumns, i, j + kColumns, j});
    }
  }
  compute_normals(mesh);
  for (std::size_t v = kColumns; v < kRows * kColumns; ++v) {
    EXPECT_GT(glm::dot(mesh.normals[v], mesh.positions[v]), 0.999f);
  }
}

TEST(Normals, ScaleDoesNotMatter) {
  for (const float scale : {1e-30f, 1e-10f, 1.0f, 1e10f, 1e30f}) {
    Mesh mesh = cube(0);
    for (glm::vec3& p : mesh.positions) p *= scale;
    compute_normals(mesh);
    for (std::size_t v = 0; v < 8; ++v) {
      EXPECT_LT(glm::distance(mesh.normals[v], glm::normalize(cube(0).positions[v])), 1e-6f);
    }
  }
}

TEST(Normals, BadTrianglesAddNothing) {
  Mesh mesh = cube(21);
  mesh.positions.emplace_back(NAN, 0, 0);
  mesh.positions.emplace_back(0, kInfinity, 0);
  // A corner twice, three in line (0, its own place, 7), not finite, past the end, half a triangle.
  mesh.positions.emplace_back(0, 0, 0);
  for (const std::uint32_t i : {0u, 0u, 1u, 0u, 10u, 7u, 0u, 8u, 1u, 1u, 9u, 2u, 0u, 1u, 99u, 5u}) {
    mesh.indices.push_back(i);
  }
  compute_normals(mesh);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_LT(glm::distance(mesh.normals[v], glm::normalize(mesh.positions[v])), 1e-6f);
  }
  for (std::size_t v = 8; v < 11; ++v) EXPECT_EQ(mesh.normals[v], glm::vec3(0, 1, 0));
}

TEST(Normals, AlwaysUnitLength) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(-1, 1);
  Mesh mesh;
  for (int i = 0; i < 300; ++i) {
    mesh.positions.emplace_back(number(random), number(random) * 1e-6f, number(random) * 1e6f);
    mesh.indices.push_back(static_cast<std::uint32_t>(random() % 300));
  }
  // A sheet and its back cancel out.
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 1u}) mesh.indices.push_back(i);
  compute_normals(mesh);
  for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-5f);
}

TEST(Normals, EmptyMesh) {
  Mesh mesh;
  mesh.normals.resize(3);
  compute_normals(mesh);
  EXPECT_TRUE(mesh.normals.empty());
}

}  // namespace
}  // namespace kinescope
