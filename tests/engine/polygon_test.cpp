#include "engine/io/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace kinescope {
namespace {

using Polygon = std::vector<glm::vec3>;

/// The sum of the triangles' areas, each by its own size.
double triangle_area(const Polygon& polygon) {
  std::vector<CornerTriple> triangles;
  triangulate(polygon, triangles);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  double area = 0.0;
  for (const CornerTriple& t : triangles) {
    const glm::dvec3 a(polygon[t[0]]), b(polygon[t[1]]), c(polygon[t[2]]);
    area += glm::length(glm::cross(b - a, c - a)) / 2.0;
  }
  return area;
}

/// Oracle: the shoelace formula, in the polygon's own plane.
double shoelace_area(const std::vector<glm::dvec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2.0;
}

Polygon lifted(const std::vector<glm::dvec2>& flat, const glm::vec3& u, const glm::vec3& v) {
  Polygon polygon;
  for (const glm::dvec2& p : flat) {
    polygon.push_back(static_cast<float>(p.x) * u + static_cast<float>(p.y) * v);
  }
  return polygon;
}

// Triangles that overlapped or left the polygon would make the sum of their areas larger.
TEST(Polygon, TrianglesCoverAnyStarOnceInAnyPlane) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  for (int round = 0; round < 200; ++round) {
    const int n = 4 + round % 40;
    std::vector<glm::dvec2> star;
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n * (round % 2 ? -1.0 : 1.0);
      star.push_back(radius(random) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    const glm::vec3 u = glm::normalize(glm::vec3(1.0f, 0.1f * static_cast<float>(round % 7), 0.3f));
    const glm::vec3 v = glm::normalize(glm::cross(u, glm::vec3(0.2f, 0.5f, 1.0f)));
    EXPECT_NEAR(triangle_area(lifted(star, u, v)), shoelace_area(star), 1e-5) << round;
  }
}

TEST(Polygon, CutsAConcaveQuadAtItsNotch) {
  const Polygon arrow{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  EXPECT_NEAR(triangle_area(arrow), 4.0, 1e-9);
}

TEST(Polygon, CompletesWhatHasNoEars) {
  EXPECT_EQ(triangle_area({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}), 0.0);
  const Polygon bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_GT(triangle_area(bow), 0.0);
  const float nan = std::nanf("");
  std::vector<CornerTriple> triangles;
  triangulate(Polygon(9, glm::vec3(nan)), triangles);
  EXPECT_EQ(triangles.size(), 7u);
  triangulate(Polygon(5000, glm::vec3(0.0f)), triangles);
  EXPECT_EQ(triangles.size(), 7u + 4998u);
}

}  // namespace
}  // namespace kinescope
