#include "bench/workloads.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "raster/base/error.h"
#include "shading/procedural_texture.h"

namespace kinescope::bench {
namespace {

struct KnotWorkload {
  const char* name;
  int along, around;  ///< quads
  ShadingModel shading;
  bool textured;
};

constexpr KnotWorkload kKnots[] = {
    {"knot-gouraud", 4096, 128, ShadingModel::kGouraud, false},
    {"knot-phong", 1280, 40, ShadingModel::kPhong, false},
    {"knot-phong-texture", 1280, 40, ShadingModel::kPhong, true},
    {"knot-coarse", 400, 13, ShadingModel::kGouraud, false},
    {"knot-micro", 8192, 256, ShadingModel::kGouraud, false},
};

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

Light point_light(glm::vec3 position, glm::vec3 colour) {
  Light light;
  light.position = position;
  light.colour = colour;
  return light;
}

Workload make_knot(const KnotWorkload& knot) {
  Workload workload;
  workload.name = knot.name;
  workload.shading = knot.shading;
  Scene& scene = workload.scene;
  Material material;
  material.base_colour = {0.8f, 0.5f, 0.3f};
  material.specular = glm::vec3(0.4f);
  material.shininess = 32;
  if (knot.textured) {
    scene.textures.emplace_back(labelled_checkerboard(1024, 1024));
    material.base_texture = 0;
  }
  scene.materials.push_back(material);
  scene.meshes.push_back(knot_mesh(knot.along, knot.around));
  scene.meshes[0].material = 0;
  scene.nodes.push_back({"knot", -1, glm::mat4(1.0f), {0}});
  scene.lights.push_back({-1, point_light({4, 5, 3}, {0.9f, 0.9f, 0.8f})});
  scene.lights.push_back({-1, point_light({-4, 2, 1}, {0.3f, 0.4f, 0.6f})});
  scene.ambient = glm::vec3(0.1f);
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

}  // namespace

std::vector<std::string> workload_names() {
  std::vector<std::string> names;
  for (const KnotWorkload& knot : kKnots) names.emplace_back(knot.name);
  return names;
}

Workload make_workload(const std::string& name) {
  std::string known;
  for (const KnotWorkload& knot : kKnots) {
    if (name == knot.name) return make_knot(knot);
    known += (known.empty() ? "" : ", ") + std::string(knot.name);
  }
  throw Error(ErrorKind::kUsage, "no workload \"" + name + "\"; there are " + known);
}

}  // namespace kinescope::bench
