#include "demos/arrange.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "engine/framing.h"

namespace kinescope {
namespace {

void shift_index(int& index, std::size_t by) {
  if (index >= 0) index += static_cast<int>(by);
}

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

/// Moves everything of `scene` into `world`, below a new node with the given transform.
void hang(Scene& world, Scene& scene, const glm::mat4& world_from_scene) {
  const std::size_t root = world.nodes.size();
  Node node;
  node.parent_from_local = world_from_scene;
  world.nodes.push_back(node);
  for (Node& child : scene.nodes) {
    child.parent =
        child.parent < 0 ? static_cast<int>(root) : child.parent + static_cast<int>(root) + 1;
    for (int& mesh : child.meshes) shift_index(mesh, world.meshes.size());
  }
  const auto place = [root](int& index) {
    index = index < 0 ? static_cast<int>(root) : index + static_cast<int>(root) + 1;
  };
  for (auto& light : scene.lights) place(light.node);
  for (auto& camera : scene.cameras) place(camera.node);
  for (Mesh& mesh : scene.meshes) shift_index(mesh.material, world.materials.size());
  for (Material& material : scene.materials) {
    shift_index(material.base_texture, world.textures.size());
  }
  append(world.nodes, scene.nodes);
  append(world.meshes, scene.meshes);
  append(world.materials, scene.materials);
  append(world.textures, scene.textures);
  append(world.lights, scene.lights);
  append(world.cameras, scene.cameras);
}

}  // namespace

glm::mat4 upright_from_model(glm::vec3 up) {
  const glm::vec3 from = glm::normalize(up), to(0, 1, 0);
  const glm::vec3 axis = glm::cross(from, to);
  const float sine = glm::length(axis), cosine = glm::dot(from, to);
  if (sine > 1e-6f) return glm::rotate(glm::mat4(1.0f), std::atan2(sine, cosine), axis / sine);
  const bool upside_down = cosine < 0;
  return upside_down ? glm::rotate(glm::mat4(1.0f), 3.14159265f, glm::vec3(1, 0, 0))
                     : glm::mat4(1.0f);
}

Scene stand_up(Scene scene, glm::vec3 up) {
  const glm::mat4 rotation = upright_from_model(up);
  if (rotation == glm::mat4(1.0f)) return scene;
  Scene world;
  world.ambient = scene.ambient;
  hang(world, scene, rotation);
  return world;
}

Scene side_by_side(std::vector<Scene> scenes) {
  if (scenes.size() == 1) return std::move(scenes.front());
  Scene world;
  float x = 0;
  for (Scene& scene : scenes) {
    const Bounds bounds = world_bounds(scene);
    const float scale = bounds.radius() > 0 ? 1 / bounds.radius() : 1.0f;
    const glm::vec3 floor_centre(bounds.centre().x, bounds.min.y, bounds.centre().z);
    const float half_width = (bounds.max.x - bounds.min.x) * 0.5f * scale;
    glm::mat4 placed = glm::translate(glm::mat4(1.0f), glm::vec3(x + half_width, 0, 0));
    placed = glm::translate(glm::scale(placed, glm::vec3(scale)), -floor_centre);
    if (&scene == &scenes.front()) world.ambient = scene.ambient;
    hang(world, scene, placed);
    x += 2 * half_width + 0.2f;  // radius 1: a tenth of the diameter
  }
  return world;
}

}  // namespace kinescope
