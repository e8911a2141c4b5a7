#include "engine/scene.h"

namespace kinescope {

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
