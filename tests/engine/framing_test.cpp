#include "engine/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "engine/teapot.h"

namespace kinescope {
namespace {

Scene scene_of(Mesh mesh, const glm::mat4& world_from_local = glm::mat4(1.0f)) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({"", -1, world_from_local, {0}});
  return scene;
}

/// Triangles of consecutive points.
Mesh mesh_of(std::vector<glm::vec3> points) {
  Mesh mesh;
  mesh.positions = std::move(points);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.indices.push_back(i);
  while (mesh.indices.size() % 3 != 0) mesh.indices.push_back(0);
  return mesh;
}

/// The greatest |x| and |y| of a scene's points in the picture, and their depths.
struct Extent {
  float x = 0, y = 0, nearest = 2, farthest = -1;
};
Extent extent_of(const Scene& scene, const Camera& camera) {
  Extent e;
  const glm::mat4 clip_from_local = camera.clip_from_world() * world_transforms(scene).front();
  for (const glm::vec3& p : scene.meshes.front().positions) {
    const glm::vec4 c = clip_from_local * glm::vec4(p, 1);
    if (!std::isfinite(c.x)) continue;
    EXPECT_GT(c.w, 0.0f);
    e.x = std::max(e.x, std::abs(c.x / c.w));
    e.y = std::max(e.y, std::abs(c.y / c.w));
    e.nearest = std::min(e.nearest, c.z / c.w);
    e.farthest = std::max(e.farthest, c.z / c.w);
  }
  return e;
}

void expect_tight(const Extent& e) {
  const float widest = std::max(e.x, e.y);
  EXPECT_LE(widest, 0.97f);
  EXPECT_GE(widest, 0.90f);
  EXPECT_GT(e.nearest, 0.0f);
  EXPECT_LT(e.farthest, 1.0f);
}

TEST(Framing, FillsThePictureFromEverySide) {
  const Scene scene = scene_of(teapot_mesh(4), glm::translate(glm::mat4(1.0f), {100, -50, 3}));
  for (const float aspect : {0.3f, 1.0f, 1.78f, 5.0f}) {
    for (float azimuth = 0; azimuth < 6.3f; azimuth += 0.7f) {
      for (const float elevation : {-1.5707964f, -0.5f, 0.0f, 0.35f, 1.2f, 1.5707964f}) {
        expect_tight(extent_of(scene, frame_scene(scene, aspect, azimuth, elevation)));
      }
    }
  }
}

TEST(Framing, AnySizeAndFieldOfView) {
  for (const float scale : {1e-12f, 1e-4f, 1.0f, 1e6f, 1e14f}) {
    const Scene scene = scene_of(teapot_mesh(3), glm::scale(glm::mat4(1.0f), glm::vec3(scale)));
    for (const float fov : {0.1f, 0.7f, 2.0f}) {
      expect_tight(extent_of(scene, frame_scene(scene, 1.5f, 0.6f, 0.35f, fov)));
    }
  }
}

TEST(Framing, LooksFromTheAnglesAsked) {
  const Scene scene = scene_of(teapot_mesh(3));
  const auto direction = [&](float azimuth, float elevation) {
    const Camera c = frame_scene(scene, 1.0f, azimuth, elevation);
    return glm::normalize(c.eye - c.look_at);
  };
  EXPECT_LT(glm::distance(direction(0, 0), glm::vec3(0, 0, 1)), 1e-5f);
  EXPECT_LT(glm::distance(direction(1.5707964f, 0), glm::vec3(1, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(direction(0, 1.5707964f), glm::vec3(0, 1, 0)), 1e-5f);
}

TEST(Framing, SurvivesScenesWithLittleOrNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const Scene scenes[] = {Scene{},
                          scene_of(Mesh{}),
                          scene_of(mesh_of({glm::vec3(nan), glm::vec3(infinity)})),
                          scene_of(mesh_of({{1, 2, 3}})),
                          scene_of(mesh_of({{0, 0, 0}, {1, 0, 0}})),
                          scene_of(mesh_of({{3e38f, 0, 0}, {-3e38f, 1, 0}, {0, 3e38f, 2}})),
                          scene_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), glm::mat4(nan))};
  for (const Scene& scene : scenes) {
    for (const Camera& camera : {frame_scene(scene, 1.3f), frame_turntable(scene, 1.3f)}) {
      EXPECT_GT(camera.near_plane, 0.0f);
      EXPECT_GT(camera.far_plane, camera.near_plane);
      EXPECT_NE(camera.eye, camera.look_at);
      const glm::mat4 m = camera.clip_from_world();
      for (int i = 0; i < 16; ++i) EXPECT_FALSE(std::isnan(m[i / 4][i % 4]));
      Scene lit = scene;
      add_default_lights(lit, camera);
      EXPECT_GE(lit.lights.size(), 3u);
      for (const auto& light : lit.lights) EXPECT_FALSE(std::isnan(light.item.position.x));
    }
  }
}

TEST(Framing, PassesOverVerticesThatAreNotFiniteOrNotDrawn) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.positions.emplace_back(NAN, 1, 1);
  mesh.positions.emplace_back(1000, 0, 0);
  mesh.indices.insert(mesh.indices.end(), {0, 1, 3, 0, 1, 77});
  const Bounds b = world_bounds(scene_of(mesh));
  EXPECT_FALSE(b.empty);
  EXPECT_EQ(b.min, glm::vec3(0, 0, 0));
  EXPECT_EQ(b.max, glm::vec3(1, 1, 0));
  EXPECT_NEAR(b.radius(), std::sqrt(2.0f) / 2, 1e-6f);
  EXPECT_TRUE(world_bounds(Scene{}).empty);
  EXPECT_EQ(Bounds{}.radius(), 0.0f);
}

TEST(Framing, TurntableStaysInThePictureAllTheWayRound) {
  const Scene scene = scene_of(teapot_mesh(4), glm::translate(glm::mat4(1.0f), {5, 5, 5}));
  for (const float aspect : {0.5f, 1.5f}) {
    for (const float elevation : {-0.6f, 0.0f, 0.35f, 1.3f}) {
      const Camera first = frame_turntable(scene, aspect, 0.2f, elevation);
      Extent whole;
      for (int i = 0; i < 90; ++i) {
        Camera camera = first;
        const glm::mat4 turn =
            glm::rotate(glm::mat4(1.0f), static_cast<float>(i) * 0.0698f, glm::vec3(0, 1, 0));
        camera.eye = first.look_at + glm::vec3(turn * glm::vec4(first.eye - first.look_at, 0));
        const Extent e = extent_of(scene, camera);
        whole = {std::max(whole.x, e.x), std::max(whole.y, e.y), std::min(whole.nearest, e.nearest),
                 std::max(whole.farthest, e.farthest)};
      }
      expect_tight(whole);
    }
  }
}

TEST(Framing, KeyLightComesFromAboveAndLeftOfTheCamera) {
  Scene scene = scene_of(teapot_mesh(3));
  const Camera camera = frame_scene(scene, 1.3f, 2.0f, 0.3f);
  add_default_lights(scene, camera);
  ASSERT_EQ(scene.lights.size(), 3u);
  const auto seen = [&](std::size_t i) {
    const glm::vec3 centre = world_bounds(scene).centre();
    return glm::mat3(camera.view_from_world()) * (scene.lights[i].item.position - centre);
  };
  EXPECT_LT(seen(0).x, 0.0f);
  EXPECT_GT(seen(0).y, 0.0f);
  EXPECT_GT(seen(0).z, 0.0f);
  EXPECT_LT(seen(2).z, 0.0f);  // the rim light stands behind
  const float radius = world_bounds(scene).radius();
  EXPECT_NEAR(glm::length(seen(0)), 4 * radius, 0.01f * radius);
}

}  // namespace
}  // namespace kinescope
