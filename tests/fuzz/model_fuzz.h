// What every fuzz target of a model reader checks: hostile bytes give one clear line, or a scene
// that the rest of the program may trust.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/framing.h"
#include "engine/io/reader.h"
#include "engine/wire_strokes.h"
#include "tests/fuzz/fuzz.h"

namespace kinescope {

inline void require(bool holds) {
  if (!holds) std::abort();
}

template <typename T>
void require_finite(const std::vector<T>& values, std::size_t count) {
  require(values.empty() || values.size() == count);
  for (const T& value : values) {
    for (int i = 0; i < T::length(); ++i) require(std::isfinite(value[i]));
  }
}

inline void require_sound(const Mesh& mesh, const Scene& scene) {
  const std::size_t count = mesh.positions.size();
  require_finite(mesh.positions, count);
  require_finite(mesh.normals, count);
  require_finite(mesh.texcoords, count);
  require_finite(mesh.colours, count);
  require(mesh.normals.size() == count);
  for (const glm::vec3& normal : mesh.normals) {
    require(std::abs(glm::length(normal) - 1.0f) < 1e-3f);
  }
  require(mesh.indices.size() % 3 == 0);
  for (const std::uint32_t index : mesh.indices) require(index < count);
  require(mesh.material >= -1 && mesh.material < static_cast<int>(scene.materials.size()));
}

inline void require_sound(const Scene& scene) {
  require(drawn_triangle_count(scene) > 0);
  for (const Mesh& mesh : scene.meshes) require_sound(mesh, scene);
  const auto meshes = static_cast<int>(scene.meshes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    require(scene.nodes[i].parent < static_cast<int>(i));
    for (const int mesh : scene.nodes[i].meshes) require(mesh >= 0 && mesh < meshes);
  }
  const auto textures = static_cast<int>(scene.textures.size());
  for (const Material& material : scene.materials) {
    require(material.base_texture >= -1 && material.base_texture < textures);
    require(material.opacity >= 0.0f && material.opacity <= 1.0f && material.shininess >= 1.0f);
    require_finite(std::vector{material.base_colour, material.specular, material.emission}, 3);
  }
}

/// Its edges, with and without the hidden ones, are strokes within the view.
inline void require_strokes(const Scene& scene) {
  constexpr std::size_t kMostFaces = 500;
  const WireScene wire = wire_scene(scene);
  if (wire.faces.size() > kMostFaces) return;
  Workers workers(1);
  const Camera camera = frame_scene(scene, 1);
  for (const bool hidden_removed : {false, true}) {
    for (const WireStroke& s : wire_strokes(wire, camera, {hidden_removed, 0.1f}, workers)) {
      for (const double v : {s.from.x, s.from.y, s.to.x, s.to.y}) require(std::abs(v) < 1 + 1e-6);
    }
  }
}

/// Nothing lies beside the file that the bytes pretend to be.
inline int fuzz_model(const std::uint8_t* data, std::size_t size, ModelFormat format) {
  fuzz_reader(data, size, [&](auto bytes) {
    Warnings warnings;
    const ModelFile file{"/nowhere/fuzz", bytes, warnings};
    if (bytes.empty()) return;
    const Scene scene = read_model(file, format);
    require_sound(scene);
    require_strokes(scene);
  });
  return 0;
}

}  // namespace kinescope
