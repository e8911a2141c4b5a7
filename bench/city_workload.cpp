// A city of boxes: near walls hide most of it.
#include <algorithm>
#include <numbers>
#include <random>

#include "bench/workload_kinds.h"

namespace kinescope::bench {
namespace {

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      glm::vec3 normal(0.0f);
      normal[axis] = upper ? 1.0f : -1.0f;
      for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        glm::vec3 p;
        p[axis] = (upper ? high : low)[axis];
        p[a] = (corner.x > 0 ? high : low)[a];
        p[b] = (corner.y > 0 ? high : low)[b];
        mesh.positions.push_back(p);
        mesh.normals.push_back(normal);
        mesh.texcoords.push_back(corner);
      }
      const std::uint32_t second = upper ? 1 : 3, last = upper ? 3 : 1;
      mesh.indices.insert(mesh.indices.end(),
                          {first, first + second, first + 2, first, first + 2, first + last});
    }
  }
}

}  // namespace

Workload city_workload() {
  constexpr int kBlocks = 40;
  constexpr float kFootprint = 0.7f;
  std::mt19937 heights(1);
  std::vector<glm::vec3> boxes;
  for (int i = 0; i < kBlocks * kBlocks; ++i) {
    const float unit = static_cast<float>(heights() >> 8) * 0x1p-24f;
    boxes.emplace_back(static_cast<float>(i % kBlocks), 0.5f + 2.5f * unit,
                       static_cast<float>(i / kBlocks));
  }
  std::mt19937 order(2);
  for (std::size_t i = boxes.size(); i > 1; --i) std::swap(boxes[i - 1], boxes[order() % i]);
  Mesh mesh;
  for (const glm::vec3 box : boxes) {
    const float reach = kFootprint / 2;
    add_box(mesh, {box.x - reach, 0, box.z - reach}, {box.x + reach, box.y, box.z + reach});
  }
  mesh.material = 0;
  Workload workload;
  Scene& scene = workload.scene;
  scene.materials.push_back(bench_material());
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({"city", -1, glm::mat4(1.0f), {0}});
  add_bench_lights(scene);
  workload.camera = [](int, float aspect) {
    Camera camera;
    camera.eye = {20.0f, 0.6f, 20.5f};
    camera.look_at = camera.eye + glm::vec3(1.0f, 0.0f, 0.3f);
    camera.near_plane = 0.05f;
    camera.far_plane = 100.0f;
    camera.set_field_of_view(std::numbers::pi_v<float> / 3, aspect);
    return camera;
  };
  return workload;
}

}  // namespace kinescope::bench
