// A world: meshes placed by a tree of transforms, with materials, lights and cameras.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/camera.h"
#include "shading/light.h"
#include "shading/material.h"
#include "shading/texture.h"

namespace kinescope {

/// Triangles of one material in local space. Arrays are empty or as long as `positions`.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;      ///< unit length; computed where a file has none
  std::vector<glm::vec2> texcoords;    ///< u to the right, v down from the image's top row
  std::vector<glm::vec3> colours;      ///< linear, multiply the material's base colour
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside
  int material = -1;                   ///< into Scene::materials; -1: the default material
};

/// A place in the transform tree. Parents come before their children in Scene::nodes.
struct Node {
  std::string name;
  int parent = -1;
  glm::mat4 parent_from_local{1.0f};
  std::vector<int> meshes;
};

/// A camera or light hung on a node.
template <typename T>
struct Placed {
  int node = -1;
  T item;
};

struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Placed<Light>> lights;  ///< in the node's local space; node -1: in world space
  std::vector<Placed<Camera>> cameras;
  glm::vec3 ambient{0.1f};
};

/// world_from_local of every node, in the order of Scene::nodes.
std::vector<glm::mat4> world_transforms(const Scene& scene);

/// The scene's lights in world space; their brightness and reach are not scaled.
std::vector<Light> world_lights(const Scene& scene);

/// A placed camera in world space: eye, look-at and up moved, its lengths as they are.
Camera world_camera(const Scene& scene, const Placed<Camera>& placed);

/// How many triangles a frame draws: a mesh counts once for every node that shows it.
std::uint64_t drawn_triangle_count(const Scene& scene);

}  // namespace kinescope
