#include "demos/arrange.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "engine/framing.h"

namespace kinescope {
namespace {

/// A box from `low` to `high` with a texture, a material, a light and a camera of its own.
Scene box(glm::vec3 low, glm::vec3 high) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {low, {high.x, low.y, low.z}, high};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.indices = {0, 1, 2};
  mesh.material = 0;
  scene.meshes.push_back(mesh);
  Node node;
  node.meshes = {0};
  scene.nodes.push_back(node);
  scene.materials.emplace_back().base_texture = 0;
  scene.textures.emplace_back();
  scene.lights.push_back({-1, {}});
  scene.cameras.push_back({0, {}});
  return scene;
}

TEST(Arrange, OneSceneStaysAsItIs) {
  const Scene scene = side_by_side({box({0, 0, 0}, {1, 1, 1})});
  EXPECT_EQ(scene.nodes.size(), 1u);
}

TEST(Arrange, ScenesStandInARowOnOneFloor) {
  const Scene world =
      side_by_side({box({5, 5, 5}, {6, 6, 6}), box({-100, 0, 0}, {900, 1000, 1000})});
  ASSERT_EQ(world.meshes.size(), 2u);
  ASSERT_EQ(world.nodes.size(), 4u);
  const auto transforms = world_transforms(world);
  std::vector<Bounds> bounds(2);
  for (std::size_t n = 0; n < world.nodes.size(); ++n) {
    EXPECT_LT(world.nodes[n].parent, static_cast<int>(n));
    for (const int mesh : world.nodes[n].meshes) {
      const auto m = static_cast<std::size_t>(mesh);
      for (const glm::vec3& p : world.meshes[m].positions) {
        bounds[m].add(glm::vec3(transforms[n] * glm::vec4(p, 1)));
      }
    }
  }
  EXPECT_NEAR(bounds[0].min.y, 0, 1e-5);
  EXPECT_NEAR(bounds[1].min.y, 0, 1e-5);
  EXPECT_NEAR(bounds[0].radius(), bounds[1].radius(), 1e-5);
  EXPECT_NEAR(bounds[1].min.x - bounds[0].max.x, 0.2f * bounds[0].radius(), 1e-5);
}

TEST(Arrange, EveryIndexFollowsItsScene) {
  const Scene world = side_by_side({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})});
  EXPECT_EQ(world.meshes[1].material, 1);
  EXPECT_EQ(world.materials[1].base_texture, 1);
  EXPECT_EQ(world.lights[1].node, 2);   // the second scene's own root
  EXPECT_EQ(world.cameras[1].node, 3);  // the node that it hung on
}

TEST(Arrange, StandingUpTurnsUpToY) {
  for (const glm::vec3 up : {glm::vec3(0, 0, 1), glm::vec3(0, -1, 0), glm::vec3(1, 2, 3),
                             glm::vec3(0, 5, 0), glm::vec3(-1, 0, 0)}) {
    const glm::mat4 rotation = upright_from_model(up);
    const glm::vec3 turned(rotation * glm::vec4(glm::normalize(up), 0));
    EXPECT_NEAR(glm::length(turned - glm::vec3(0, 1, 0)), 0, 1e-6);
    const glm::vec3 x(rotation[0]), y(rotation[1]), z(rotation[2]);
    EXPECT_NEAR(glm::dot(glm::cross(x, y), z), 1, 1e-5);  // a rotation, no mirror
  }
}

}  // namespace
}  // namespace kinescope
