// Overdraw: quads that fill the picture, one behind another.
#include <random>

#include "bench/workload_kinds.h"
#include "shading/procedural_texture.h"

namespace kinescope::bench {

Workload layers_workload(int layers, bool near_first, bool textured, float opacity) {
  Workload workload;
  workload.shading = ShadingModel::kUnlit;
  std::mt19937 random(1);
  const auto uniform = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  Mesh mesh;
  for (int i = 0; i < layers; ++i) {
    const float z = -1.0f - static_cast<float>(near_first ? i : layers - 1 - i);
    // Between one and two texels a pixel, at another angle in every layer.
    const glm::vec2 along_x(2.0f + uniform(), uniform() - 0.5f);
    const glm::vec2 along_y(uniform() - 0.5f, 1.0f + uniform());
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      mesh.positions.emplace_back(corner * 2.0f - 1.0f, z);
      mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
      mesh.texcoords.push_back(corner.x * along_x + corner.y * along_y);
      mesh.colours.emplace_back(uniform(), uniform(), uniform());
    }
    mesh.indices.insert(mesh.indices.end(),
                        {first, first + 1, first + 2, first, first + 2, first + 3});
  }
  Material material;
  material.base_colour = glm::vec3(1.0f);
  material.opacity = opacity;
  Scene& scene = workload.scene;
  if (textured) {
    mesh.colours.clear();
    scene.textures.emplace_back(labelled_checkerboard(1024, 1024));
    material.base_texture = 0;
  }
  mesh.material = 0;
  scene.materials.push_back(material);
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({"layers", -1, glm::mat4(1.0f), {0}});
  workload.camera = [layers](int, float) {
    Camera camera;
    camera.projection = Projection::kOrthographic;
    camera.eye = glm::vec3(0.0f);
    camera.look_at = {0.0f, 0.0f, -1.0f};
    camera.near_plane = 0.5f;
    camera.far_plane = static_cast<float>(layers) + 1.0f;
    return camera;
  };
  return workload;
}

}  // namespace kinescope::bench
