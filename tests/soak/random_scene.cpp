#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/renderer.h"
#include "raster/base/simd.h"
#include "shading/procedural_texture.h"
#include "tests/raster/triangle_soup.h"
#include "tests/soak/random_frame.h"
#include "tests/soak/same_picture.h"

namespace kinescope::soak {
namespace {

glm::vec3 in_cube(RandomTriangles& random, float half) {
  const float x = random.between(-half, half), y = random.between(-half, half);
  return {x, y, random.between(-half, half)};
}

Mesh random_mesh(RandomTriangles& random) {
  Mesh mesh;
  const int vertices = 3 + random.below(600);
  const bool coloured = random.below(3) == 0, textured = random.below(2) == 0;
  for (int i = 0; i < vertices; ++i) {
    mesh.positions.push_back(in_cube(random, random.below(20) ? 1.0f : 30.0f));
    mesh.normals.push_back(glm::normalize(in_cube(random, 1.0f) + glm::vec3(1e-3f)));
    if (textured) mesh.texcoords.emplace_back(random.between(-3, 3), random.between(-3, 3));
    if (coloured) mesh.colours.push_back(in_cube(random, 1.0f));
  }
  for (int n = 3 * random.below(700); n > 0; --n) {
    mesh.indices.push_back(static_cast<std::uint32_t>(random.below(vertices)));
  }
  if (random.below(3) == 0) {
    for (int n = random.below(5); n > 0; --n) {
      mesh.positions[static_cast<std::size_t>(random.below(vertices))].x =
          random.below(2) ? std::numeric_limits<float>::quiet_NaN() : 3e38f;
    }
    if (random.below(4) == 0 && !mesh.indices.empty()) mesh.indices.back() = 1u << 30;
  }
  mesh.material = random.below(4) - 1;
  return mesh;
}

Light random_light(RandomTriangles& random) {
  Light light;
  light.kind = std::array{LightKind::kDirectional, LightKind::kPoint,
                          LightKind::kSpot}[static_cast<std::size_t>(random.below(3))];
  light.position = in_cube(random, 4);
  light.direction = in_cube(random, 1);
  light.outer_cone_rad = random.between(0, 2);
  light.attenuation = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
  return light;
}

Scene random_scene(RandomTriangles& random) {
  Scene scene;
  const int meshes = 1 + random.below(4);
  for (int i = 0; i < meshes; ++i) scene.meshes.push_back(random_mesh(random));
  scene.textures.emplace_back(labelled_checkerboard(1 + random.below(70), 1 + random.below(70)));
  for (int i = 0; i < 3; ++i) {
    Material material;
    material.base_colour = in_cube(random, 1) + 0.5f;
    material.specular = glm::vec3(random.between(0, 1));
    material.shininess = random.between(0, 200);
    material.double_sided = random.below(2) == 0;
    material.base_texture = random.below(2) - 1;
    scene.materials.push_back(material);
  }
  for (int i = random.below(6); i >= 0; --i) {
    glm::mat4 m(1.0f);
    // Mirrors, flat scalings and slants among them.
    for (int column = 0; column < 3; ++column) m[column] = glm::vec4(in_cube(random, 1.5f), 0.0f);
    if (random.below(4) == 0) m[random.below(3)] = glm::vec4(0.0f);
    m[3] = glm::vec4(in_cube(random, 1.5f), 1.0f);
    const int parent = static_cast<int>(scene.nodes.size()) - 1 - random.below(3);
    scene.nodes.push_back({"", std::max(parent, -1), m, {random.below(meshes)}});
  }
  for (int i = random.below(5); i > 0; --i) {
    const int node = random.below(static_cast<int>(scene.nodes.size()) + 1) - 1;
    scene.lights.push_back({node, random_light(random)});
  }
  return scene;
}

/// Often within the scene, so that triangles reach behind the eye.
Camera random_camera(RandomTriangles& random) {
  Camera camera;
  camera.eye = in_cube(random, random.below(2) ? 1.0f : 5.0f);
  camera.look_at = in_cube(random, 1);
  camera.up = in_cube(random, 1);
  if (random.below(4) == 0) camera.projection = Projection::kOrthographic;
  camera.near_plane = std::pow(10.0f, random.between(-6, 0));
  camera.far_plane = camera.near_plane + std::pow(10.0f, random.between(-2, 4));
  camera.set_field_of_view(random.between(0.05f, 3.0f), random.between(0.3f, 3.0f));
  return camera;
}

RenderSettings random_settings(RandomTriangles& random) {
  RenderSettings settings;
  settings.shading = static_cast<ShadingModel>(random.below(5));
  settings.wireframe = random.below(4) == 0;
  settings.points = random.below(6) == 0;
  settings.hidden_wire = random.below(2) == 0;
  settings.textures = random.below(4) != 0;
  settings.wire_width_px = random.between(0, 5);
  settings.point_size_px = random.between(0, 9);
  return settings;
}

}  // namespace

std::string check_random_scene(std::uint64_t seed) {
  RandomTriangles random(static_cast<unsigned>(seed));
  const Scene scene = random_scene(random);
  const Camera camera = random_camera(random);
  const RenderSettings settings = random_settings(random);
  const int width = 1 + random.below(200), height = 1 + random.below(150);
  const int samples = std::array{1, 4, 8}[static_cast<std::size_t>(random.below(3))];
  const std::vector<std::string> targets = simd_targets();
  use_simd_target(
      targets[static_cast<std::size_t>(random.below(static_cast<int>(targets.size())))]);
  RenderTarget first;
  std::uint64_t hash = 0;
  for (int n = 0; n < 3; ++n) {
    Workers workers(n == 0 ? 1 : 2 + random.below(3));
    Renderer renderer(workers);
    RenderTarget target(width, height, samples);
    RenderStats stats = renderer.render(scene, camera, settings, target, true);
    if (n == 0) {
      first = target;
      hash = stats.raster.visibility_hash;
    }
    const bool same = same_picture(first, target) && hash == stats.raster.visibility_hash;
    stats = renderer.render(scene, camera, settings, target, true);
    if (!same || !same_picture(first, target) || hash != stats.raster.visibility_hash) {
      return fmt::format("another picture of a scene: {}x{}, {} samples, {} threads, {}{}", width,
                         height, samples, workers.count(), simd_target(),
                         same ? ", the second time" : "");
    }
  }
  return {};
}

}  // namespace kinescope::soak
