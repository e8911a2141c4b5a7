#include "engine/scene.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

namespace kinescope {
namespace {

constexpr float kHalfPi = std::numbers::pi_v<float> / 2;

glm::mat4 moved(float x, float y, float z) {
  return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

Node node(int parent, const glm::mat4& m) { return {"", parent, m, {}}; }

TEST(Scene, TransformsMultiplyDownTheTree) {
  Scene scene;
  scene.nodes = {node(-1, moved(1, 0, 0)),
                 node(0, glm::rotate(glm::mat4(1.0f), kHalfPi, glm::vec3(0, 0, 1))),
                 node(1, moved(0, 2, 0)), node(-1, moved(0, 0, 9))};
  const auto world = world_transforms(scene);
  ASSERT_EQ(world.size(), 4u);
  const auto place = [&](std::size_t n) { return glm::vec3(world[n] * glm::vec4(0, 0, 0, 1)); };
  EXPECT_LT(glm::distance(place(0), glm::vec3(1, 0, 0)), 1e-6f);
  // Two up in the turned frame is two to the left.
  EXPECT_LT(glm::distance(place(2), glm::vec3(-1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::distance(place(3), glm::vec3(0, 0, 9)), 1e-6f);
}

TEST(Scene, ParentsThatDoNotComeFirstAreNone) {
  Scene scene;
  scene.nodes = {node(0, moved(1, 0, 0)), node(7, moved(2, 0, 0)), node(-5, moved(3, 0, 0))};
  const auto world = world_transforms(scene);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(world[n], moved(static_cast<float>(n + 1), 0, 0));
  }
}

TEST(Scene, CountsATriangleForEveryNodeThatShowsIt) {
  Scene scene;
  scene.meshes.resize(2);
  scene.meshes[0].indices.resize(6);
  scene.meshes[1].indices.resize(30);
  scene.nodes.resize(3);
  scene.nodes[0].meshes = {0, 1};
  scene.nodes[1].meshes = {0};
  scene.nodes[2].meshes = {-1, 5};
  EXPECT_EQ(drawn_triangle_count(scene), 2u + 10u + 2u);
}

TEST(Scene, LightsAndCamerasRideOnTheirNodes) {
  Scene scene;
  scene.nodes = {
      node(-1, moved(1, 2, 3) * glm::rotate(glm::mat4(1.0f), kHalfPi, glm::vec3(0, 1, 0)) *
                   glm::scale(glm::mat4(1.0f), glm::vec3(5.0f)))};
  Light light;
  light.position = {1, 0, 0};
  light.direction = {0, 0, -1};
  scene.lights = {{0, light}, {-1, light}, {12, light}};
  const std::vector<Light> lights = world_lights(scene);
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_LT(glm::distance(lights[0].position, glm::vec3(1, 2, -2)), 1e-5f);
  EXPECT_LT(glm::distance(lights[0].direction, glm::vec3(-1, 0, 0)), 1e-6f);
  EXPECT_EQ(lights[1].position, light.position);
  EXPECT_EQ(lights[2].direction, light.direction);

  Camera camera;
  camera.eye = {0, 0, 0};
  camera.look_at = {0, 0, -2};
  const Camera placed = world_camera(scene, {0, camera});
  EXPECT_LT(glm::distance(placed.eye, glm::vec3(1, 2, 3)), 1e-6f);
  EXPECT_LT(glm::distance(placed.look_at, glm::vec3(-1, 2, 3)), 1e-6f);
  EXPECT_LT(glm::distance(placed.up, glm::vec3(0, 1, 0)), 1e-6f);
}

}  // namespace
}  // namespace kinescope
