// A torus knot of many or few triangles, lit by two lamps.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench/workload_kinds.h"
#include "shading/procedural_texture.h"

namespace kinescope::bench {
namespace {

constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;

/// Centre line of the (2,3) torus knot.
glm::vec3 knot_centre(float a) {
  const float radius = 2 + std::cos(3 * a);
  return 0.5f * glm::vec3(radius * std::cos(2 * a), radius * std::sin(2 * a), -std::sin(3 * a));
}

Mesh knot_mesh(int along, int around) {
  constexpr float kTubeRadius = 0.35f;
  Mesh mesh;
  for (int i = 0; i <= along; ++i) {
    const float u = static_cast<float>(i) / static_cast<float>(along);
    const glm::vec3 here = knot_centre(u * kTwoPi);
    const glm::vec3 ahead = knot_centre(u * kTwoPi + 0.001f);
    const glm::vec3 tangent = glm::normalize(ahead - here);
    const glm::vec3 binormal = glm::normalize(glm::cross(tangent, ahead + here));
    const glm::vec3 normal = glm::cross(binormal, tangent);
    for (int j = 0; j <= around; ++j) {
      const float v = static_cast<float>(j) / static_cast<float>(around);
      const glm::vec3 outward = std::cos(v * kTwoPi) * normal + std::sin(v * kTwoPi) * binormal;
      mesh.positions.push_back(here + kTubeRadius * outward);
      mesh.normals.push_back(outward);
      mesh.texcoords.emplace_back(16 * u, 2 * v);
    }
  }
  const auto vertex = [around](int i, int j) {
    return static_cast<std::uint32_t>(i * (around + 1) + j);
  };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  return mesh;
}

}  // namespace

Workload knot_workload(const KnotShape& knot) {
  Workload workload;
  workload.shading = knot.shading;
  Scene& scene = workload.scene;
  Material material = bench_material();
  if (knot.textured) {
    scene.textures.emplace_back(labelled_checkerboard(1024, 1024));
    material.base_texture = 0;
  }
  scene.materials.push_back(material);
  scene.meshes.push_back(knot_mesh(knot.along, knot.around));
  scene.meshes[0].material = 0;
  scene.nodes.push_back({"knot", -1, glm::mat4(1.0f), {0}});
  add_bench_lights(scene);
  workload.camera = [](int frame, float aspect) {
    const float t = 0.05f * static_cast<float>(frame);
    Camera camera;
    camera.eye = {3.2f * std::sin(t), 1.2f, 3.2f * std::cos(t)};
    camera.look_at = glm::vec3(0.0f);
    camera.near_plane = 0.1f;
    camera.far_plane = 20.0f;
    camera.set_field_of_view(std::numbers::pi_v<float> / 4, aspect);
    return camera;
  };
  return workload;
}

}  // namespace kinescope::bench
