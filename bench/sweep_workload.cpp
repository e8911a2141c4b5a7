// Triangles of one size at random places: what a triangle costs, and what a pixel.
#include <algorithm>
#include <random>

#include "bench/workload_kinds.h"

namespace kinescope::bench {

Workload sweep_workload(int leg_px, int most) {
  constexpr float kWidth = 1920, kHeight = 1080;
  const auto leg = static_cast<float>(leg_px);
  const int count = std::min(most, 100'000'000 / (leg_px * leg_px));
  std::mt19937 random(1);
  const auto uniform = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 corner(uniform() * kWidth, uniform() * kHeight, -uniform());
    const float turn =
        random() & 1 ? 1.0f : -1.0f;  // right angle at the lower left, or upper right
    for (const glm::vec2 way : {glm::vec2(0, 0), {leg, 0}, {0, leg}}) {
      mesh.positions.push_back(corner + glm::vec3(way * turn, 0.0f));
      mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
      mesh.texcoords.emplace_back(0.0f, 0.0f);
      mesh.colours.emplace_back(uniform(), uniform(), uniform());
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
    }
  }
  mesh.material = 0;
  Workload workload;
  workload.shading = ShadingModel::kUnlit;
  Material material;
  material.base_colour = glm::vec3(1.0f);
  workload.scene.materials.push_back(material);
  workload.scene.meshes.push_back(std::move(mesh));
  workload.scene.nodes.push_back({"sweep", -1, glm::mat4(1.0f), {0}});
  workload.camera = [](int, float) {
    Camera camera;
    camera.projection = Projection::kOrthographic;
    camera.eye = {0.0f, 0.0f, 1.0f};
    camera.look_at = glm::vec3(0.0f);
    camera.window_min = {0.0f, 0.0f};
    camera.window_max = {kWidth, kHeight};
    camera.near_plane = 0.5f;
    camera.far_plane = 2.5f;
    return camera;
  };
  return workload;
}

}  // namespace kinescope::bench
