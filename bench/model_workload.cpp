// Any model file as a workload.
#include <glm/geometric.hpp>

#include "bench/workload_kinds.h"
#include "engine/framing.h"
#include "engine/io/import.h"
#include "engine/normals.h"

namespace kinescope::bench {
namespace {

void append(Mesh& all, const Mesh& mesh, const glm::mat4& world_from_local) {
  const auto first = static_cast<std::uint32_t>(all.positions.size());
  for (const glm::vec3& p : mesh.positions) {
    all.positions.emplace_back(world_from_local * glm::vec4(p, 1.0f));
  }
  for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
}

}  // namespace

Workload model_workload(const std::string& path) {
  Warnings warnings;
  const Scene model = import_model(path, warnings);
  const std::vector<glm::mat4> world_from_local = world_transforms(model);
  Workload workload;
  workload.name = path.substr(path.find_last_of('/') + 1);
  Mesh all;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    for (const int m : model.nodes[n].meshes) {
      append(all, model.meshes[static_cast<std::size_t>(m)], world_from_local[n]);
    }
  }
  compute_normals(all);
  all.texcoords.resize(all.positions.size());
  all.material = 0;
  Scene& scene = workload.scene;
  scene.materials.push_back(bench_material());
  scene.meshes.push_back(std::move(all));
  scene.nodes.push_back({"model", -1, glm::mat4(1.0f), {0}});
  add_default_lights(scene, frame_scene(scene, 16.0f / 9.0f));
  for (auto& light : scene.lights) {  // the peer knows point lights
    if (light.item.kind == LightKind::kPoint) continue;
    light.item.position =
        world_bounds(scene).centre() - 100.0f * world_bounds(scene).radius() * light.item.direction;
    light.item.kind = LightKind::kPoint;
    light.item.attenuation = {1.0f, 0.0f, 0.0f};
  }
  workload.camera = [scene](int frame, float aspect) {
    return frame_scene(scene, aspect, 0.6f + 0.05f * static_cast<float>(frame));
  };
  return workload;
}

}  // namespace kinescope::bench
