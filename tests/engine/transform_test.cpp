#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <random>

#include "engine/vertex_transform.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

/// Runs a test on every instruction set that this machine has.
class VertexTransform : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { use_simd_target(GetParam()); }
  void TearDown() override { use_simd_target("best"); }
};
INSTANTIATE_TEST_SUITE_P(Simd, VertexTransform, ::testing::ValuesIn(simd_targets()),
                         [](const auto& target) { return target.param; });

Projector some_projector(float guard_band_px = 32768.0f) {
  Camera camera;
  camera.eye = {1, 2, 5};
  camera.look_at = {0.3f, 0, 0};
  camera.near_plane = 0.5f;
  camera.far_plane = 20.0f;
  camera.set_field_of_view(0.9f, 1.5f);
  return make_projector(camera.clip_from_world(), {0, 0, 300, 200}, guard_band_px);
}

Positions random_positions(std::size_t count, float range) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(-range, range);
  Positions p;
  p.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    p.x[i] = number(random);
    p.y[i] = number(random);
    p.z[i] = number(random);
  }
  return p;
}

/// The law in plain words, in single precision.
glm::vec4 clip_of(const Projector& p, const Positions& world, std::size_t i) {
  glm::vec4 clip;
  for (int r = 0; r < 4; ++r) {
    const glm::mat4& m = p.clip_from_world;
    clip[r] = ((m[0][r] * world.x[i] + m[1][r] * world.y[i]) + m[2][r] * world.z[i]) + m[3][r];
  }
  return clip;
}

DevicePositions project_all(const Projector& p, const Positions& world) {
  DevicePositions device;
  device.resize(world.count + Positions::kPadding);
  project(p, world, 0, world.count, device);
  return device;
}

TEST_P(VertexTransform, ProjectsAsTheScalarLawToTheLastBit) {
  const Projector p = some_projector();
  const Positions world = random_positions(1003, 4.0f);
  const DevicePositions device = project_all(p, world);
  int kept = 0;
  for (std::size_t i = 0; i < world.count; ++i) {
    const glm::vec4 clip = clip_of(p, world, i);
    if ((device.outcodes[i] & outcode::kMustCut) != 0) {
      EXPECT_EQ(device.vertices[i].x_px, 0.0f);
      EXPECT_EQ(device.vertices[i].inv_w, 1.0f);
      continue;
    }
    ++kept;
    const float inv_w = 1.0f / clip.w;
    EXPECT_EQ(device.vertices[i].inv_w, inv_w);
    EXPECT_EQ(device.vertices[i].x_px, clip.x * inv_w * 150.0f + 150.0f);
    EXPECT_EQ(device.vertices[i].y_px, clip.y * inv_w * -100.0f + 100.0f);
    EXPECT_EQ(device.vertices[i].z, std::min(clip.z * inv_w, 1.0f));
  }
  EXPECT_GT(kept, 500);
}

TEST_P(VertexTransform, OutcodesSayWhichPlanesAreCrossed) {
  const Projector p = some_projector(1000.0f);
  const Positions world = random_positions(5000, 30.0f);
  const DevicePositions device = project_all(p, world);
  int seen = 0;
  for (std::size_t i = 0; i < world.count; ++i) {
    const glm::vec4 c = clip_of(p, world, i);
    int want = 0;
    if (c.x < -c.w) want |= outcode::kLeft;
    if (c.x > c.w) want |= outcode::kRight;
    if (c.y < -c.w) want |= outcode::kBottom;
    if (c.y > c.w) want |= outcode::kTop;
    if (c.z < 0) want |= outcode::kNear;
    if (c.z > c.w) want |= outcode::kFar;
    EXPECT_EQ(device.outcodes[i] & outcode::kVolume, want);
    seen |= device.outcodes[i];
    // Inside the guard band means: on the device within its pixels.
    const float x = c.x / c.w * 150 + 150, y = c.y / c.w * -100 + 100;
    const bool holds = c.w > 0 && std::abs(x) <= 998 && std::abs(y) <= 998;
    const bool lost = c.w <= 0 || std::abs(x) >= 1000 || std::abs(y) >= 1000;
    if (holds) {
      EXPECT_EQ(device.outcodes[i] & outcode::kGuard, 0);
    }
    if (lost) {
      EXPECT_NE(device.outcodes[i] & outcode::kGuard, 0);
    }
  }
  EXPECT_EQ(seen, 127);
}

TEST_P(VertexTransform, MarksWhatIsNotFinite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float bad[] = {NAN, kInfinity, -kInfinity, 3e38f};
  Positions world;
  world.resize(13);
  for (std::size_t i = 0; i < 12; ++i) {
    (i % 3 == 0 ? world.x : i % 3 == 1 ? world.y : world.z)[i] = bad[i / 3];
  }
  DevicePositions device;
  device.resize(world.count + Positions::kPadding);
  const OutcodeSummary summary = project(some_projector(), world, 0, world.count, device);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NE(device.outcodes[i] & outcode::kNotFinite, 0) << i;
  }
  for (std::size_t i = 0; i < 13; ++i) {
    EXPECT_TRUE(std::isfinite(device.vertices[i].x_px) && std::isfinite(device.vertices[i].z));
  }
  EXPECT_EQ(device.outcodes[12], 0);
  EXPECT_NE(summary.any & outcode::kNotFinite, 0);
  EXPECT_EQ(summary.all, 0);
}

TEST_P(VertexTransform, BatchesDoNotMatter) {
  const Projector p = some_projector();
  const Positions world = random_positions(777, 6.0f);
  const DevicePositions whole = project_all(p, world);
  DevicePositions parts;
  parts.resize(world.count + Positions::kPadding);
  OutcodeSummary sum;
  for (std::size_t begin = 0; begin < world.count; begin += 48) {
    const auto part = project(p, world, begin, std::min(world.count, begin + 48), parts);
    sum.any |= part.any;
    sum.all &= part.all;
  }
  for (std::size_t i = 0; i < world.count; ++i) {
    EXPECT_EQ(whole.vertices[i].x_px, parts.vertices[i].x_px);
    EXPECT_EQ(whole.outcodes[i], parts.outcodes[i]);
  }
  EXPECT_EQ(sum.all, 0);
}

/// Vertices with their normals moved to the world: the rows.
std::vector<float> rows_of(const glm::mat4& m, const std::vector<glm::vec3>& positions,
                           const std::vector<glm::vec3>& normals, Positions& world) {
  std::vector<float> rows(positions.size() * 8);
  world.resize(positions.size());
  to_world(make_world_transform(m), positions, normals, 0, positions.size(), world, rows, 8);
  return rows;
}

TEST_P(VertexTransform, NormalsStaySquareToTheirSurface) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-2, 2);
  const auto any = [&] { return glm::vec3(number(random), number(random), number(random)); };
  for (int round = 0; round < 50; ++round) {
    glm::mat4 m(1.0f);
    for (int i = 0; i < 4; ++i) m[i] = glm::vec4(any(), i == 3 ? 1 : 0);
    std::vector<glm::vec3> positions, normals;
    // Pairs of tangents beside each normal.
    std::vector<glm::vec3> s, t;
    for (int i = 0; i < 70; ++i) {
      s.push_back(any());
      t.push_back(any());
      positions.push_back(any());
      normals.push_back(glm::normalize(glm::cross(s.back(), t.back())));
    }
    Positions world;
    const std::vector<float> rows = rows_of(m, positions, normals, world);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const glm::vec3 p(rows[i * 8], rows[i * 8 + 1], rows[i * 8 + 2]);
      const glm::vec3 n(rows[i * 8 + 3], rows[i * 8 + 4], rows[i * 8 + 5]);
      EXPECT_LT(glm::distance(p, glm::vec3(m * glm::vec4(positions[i], 1))), 2e-5f);
      EXPECT_EQ(world.x[i], p.x);
      EXPECT_NEAR(glm::length(n), 1.0f, 1e-5f);
      const glm::vec3 ws = glm::normalize(glm::mat3(m) * s[i]);
      const glm::vec3 wt = glm::normalize(glm::mat3(m) * t[i]);
      EXPECT_NEAR(glm::dot(n, ws), 0.0f, 2e-3f);
      EXPECT_NEAR(glm::dot(n, wt), 0.0f, 2e-3f);
      // It stays on its side of the surface, even in a mirror.
      EXPECT_GT(glm::dot(n, glm::mat3(m) * normals[i]), 0.0f);
    }
  }
}

TEST_P(VertexTransform, NormalsSurviveFlatAndExtremeScales) {
  const std::vector<glm::vec3> positions(3, glm::vec3(1, 2, 3));
  const std::vector<glm::vec3> normals{{0, 1, 0}, {0.6f, 0.8f, 0}, {0, 0, 0}};
  for (const glm::vec3 scale : {glm::vec3(1e-25f), glm::vec3(1e15f), glm::vec3(-1), glm::vec3(0),
                                glm::vec3(1, 0, 1), glm::vec3(NAN)}) {
    Positions world;
    const std::vector<float> rows =
        rows_of(glm::scale(glm::mat4(1.0f), scale), positions, normals, world);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 n(rows[i * 8 + 3], rows[i * 8 + 4], rows[i * 8 + 5]);
      const float length = glm::length(n);
      EXPECT_TRUE(length == 0.0f || std::abs(length - 1.0f) < 1e-5f) << length;
      if (i == 0) {
        EXPECT_NEAR(std::abs(n.y), 1.0f, 1e-6f) << "scale " << scale.y;
      }
    }
  }
}

TEST(WorldTransform, TellsMirrors) {
  const glm::mat4 one(1.0f);
  EXPECT_FALSE(make_world_transform(one).mirrors);
  EXPECT_TRUE(make_world_transform(glm::scale(one, glm::vec3(1, 1, -1))).mirrors);
  EXPECT_FALSE(make_world_transform(glm::scale(one, glm::vec3(-1, 1, -1))).mirrors);
  EXPECT_TRUE(make_world_transform(glm::scale(one, glm::vec3(-1e-12f))).mirrors);
}

TEST(Positions, PaddingReadsAsZeros) {
  Positions p;
  p.resize(64);
  std::fill(p.x.begin(), p.x.end(), 9.0f);
  p.resize(10);
  for (std::size_t i = 10; i < 26; ++i) EXPECT_EQ(p.x.at(i), 0.0f);
}

}  // namespace
}  // namespace kinescope
