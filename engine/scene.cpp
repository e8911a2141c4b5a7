#include "engine/scene.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace kinescope {
namespace {

glm::mat4 world_from_node(const std::vector<glm::mat4>& transforms, int node) {
  const bool placed = node >= 0 && static_cast<std::size_t>(node) < transforms.size();
  return placed ? transforms[static_cast<std::size_t>(node)] : glm::mat4(1.0f);
}

glm::vec3 moved_point(const glm::mat4& m, glm::vec3 p) { return glm::vec3(m * glm::vec4(p, 1)); }

/// A zero direction stays one.
glm::vec3 moved_direction(const glm::mat4& m, glm::vec3 d) {
  const glm::vec3 moved(m * glm::vec4(d, 0));
  const float length = glm::length(moved);
  return length > 0.0f ? moved / length : moved;
}

}  // namespace

std::vector<glm::mat4> world_transforms(const Scene& scene) {
  std::vector<glm::mat4> world_from_local;
  world_from_local.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) {
    const auto parent = static_cast<std::size_t>(node.parent);
    // A parent that does not come first is not one: the node hangs on the root.
    const bool has_parent = node.parent >= 0 && parent < world_from_local.size();
    world_from_local.push_back(has_parent ? world_from_local[parent] * node.parent_from_local
                                          : node.parent_from_local);
  }
  return world_from_local;
}

std::vector<Light> world_lights(const Scene& scene) {
  const std::vector<glm::mat4> transforms = world_transforms(scene);
  std::vector<Light> lights;
  for (const Placed<Light>& placed : scene.lights) {
    const glm::mat4 m = world_from_node(transforms, placed.node);
    Light light = placed.item;
    light.position = moved_point(m, light.position);
    light.direction = moved_direction(m, light.direction);
    lights.push_back(light);
  }
  return lights;
}

Camera world_camera(const Scene& scene, const Placed<Camera>& placed) {
  const glm::mat4 m = world_from_node(world_transforms(scene), placed.node);
  Camera camera = placed.item;
  camera.up = moved_direction(m, camera.up);
  const glm::vec3 forward = moved_direction(m, camera.look_at - camera.eye);
  const float distance = glm::length(camera.look_at - camera.eye);
  camera.eye = moved_point(m, camera.eye);
  camera.look_at = camera.eye + forward * distance;
  return camera;
}

std::uint64_t drawn_triangle_count(const Scene& scene) {
  std::uint64_t triangles = 0;
  for (const Node& node : scene.nodes) {
    for (const int mesh : node.meshes) {
      if (mesh < 0 || static_cast<std::size_t>(mesh) >= scene.meshes.size()) continue;
      triangles += scene.meshes[static_cast<std::size_t>(mesh)].indices.size() / 3;
    }
  }
  return triangles;
}

}  // namespace kinescope
