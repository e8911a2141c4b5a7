// Small scenes for the renderer's tests, and pictures of them to compare.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/framing.h"
#include "engine/renderer.h"
#include "engine/teapot.h"

namespace kinescope {

inline constexpr glm::vec3 kZero(0.0f);

inline Scene scene_of(Mesh mesh, const glm::mat4& world_from_local = glm::mat4(1.0f)) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({"", -1, world_from_local, {0}});
  return scene;
}

inline Scene lit_teapot(int fineness) {
  Scene scene = scene_of(teapot_mesh(fineness));
  Material material;
  material.base_colour = {0.7f, 0.4f, 0.2f};
  material.specular = glm::vec3(0.5f);
  scene.materials.push_back(material);
  scene.meshes[0].material = 0;
  add_default_lights(scene, frame_scene(scene, 1.5f));
  return scene;
}

struct Picture {
  RenderTarget target;
  RenderStats stats;
  const Image<LinearRgba>& pixels() const { return std::get<Image<LinearRgba>>(target.colour); }
};

inline Picture render_with(Renderer& renderer, const Scene& scene, const Camera& camera,
                           const RenderSettings& settings = {}, int width = 150, int height = 100) {
  Picture picture{RenderTarget(width, height, 1, ColourFormat::kLinearFloat), {}};
  picture.stats = renderer.render(scene, camera, settings, picture.target, true);
  return picture;
}

inline Picture render(const Scene& scene, const Camera& camera, const RenderSettings& settings = {},
                      int width = 150, int height = 100) {
  Workers workers(2);
  Renderer renderer(workers);
  return render_with(renderer, scene, camera, settings, width, height);
}

inline RenderSettings with(ShadingModel shading) {
  RenderSettings settings;
  settings.shading = shading;
  return settings;
}

inline float difference(LinearRgba a, LinearRgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// How many pixels differ by more than a tolerance.
inline int differing(const Picture& a, const Picture& b, float tolerance = 0.0f) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().pixels().size(); ++i) {
    count += difference(a.pixels().pixels()[i], b.pixels().pixels()[i]) > tolerance;
  }
  return count;
}

inline int painted(const Picture& p) {
  return static_cast<int>(std::count_if(p.pixels().pixels().begin(), p.pixels().pixels().end(),
                                        [](LinearRgba c) { return c != LinearRgba{}; }));
}

/// A floor at y = 0 from (-size, 0, -size) to (size, 0, size), its texture coordinates and colours
/// running from 0 to 1 along x and z.
inline Mesh floor_mesh(float size) {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    const float u = static_cast<float>(i & 1), v = static_cast<float>(i >> 1);
    mesh.positions.emplace_back((2 * u - 1) * size, 0.0f, (2 * v - 1) * size);
    mesh.normals.emplace_back(0, 1, 0);
    mesh.texcoords.emplace_back(u, v);
    mesh.colours.emplace_back(u, v, 0.25f);
  }
  mesh.indices = {0, 2, 3, 0, 3, 1};
  return mesh;
}

inline Camera floor_camera() {
  Camera camera;
  camera.eye = {1, 2, 3};
  camera.look_at = {-1, 0, -8};
  camera.set_field_of_view(1.0f, 1.5f);
  return camera;
}

inline Scene floor_scene(float size) {
  Scene scene = scene_of(floor_mesh(size));
  Material white;
  white.base_colour = glm::vec3(1.0f);
  scene.materials.push_back(white);
  scene.meshes[0].material = 0;
  return scene;
}

}  // namespace kinescope
