// What every format needs once it is read.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "engine/io/crease_normals.h"
#include "engine/io/reader.h"
#include "engine/normals.h"

namespace kinescope {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// Beyond this, squares of lengths leave a float's range.
constexpr float kLargestCoordinate = 1e18f;

bool is_usable(const glm::vec3& v) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(v[i]) <= kLargestCoordinate)) return false;
  }
  return true;
}

/// @return how many triangles went
std::size_t drop_unusable_triangles(Mesh& mesh) {
  std::vector<bool> usable;
  usable.reserve(mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) usable.push_back(is_usable(position));
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t* corner = &mesh.indices[i];
    if (!usable[corner[0]] || !usable[corner[1]] || !usable[corner[2]]) continue;
    for (std::size_t k = 0; k < 3; ++k) mesh.indices[kept++] = corner[k];
  }
  const std::size_t dropped = mesh.indices.size() / 3 - kept / 3;
  mesh.indices.resize(kept);
  return dropped;
}

template <typename T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& new_index, std::size_t count) {
  if (values.empty()) return;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    // A vertex never moves up, so nothing is overwritten before it is read.
    if (new_index[i] != kUnused) values[new_index[i]] = values[i];
  }
  values.resize(count);
}

/// Keeps stray points, which need not even be finite, out of what frames the model.
void drop_unused_vertices(Mesh& mesh) {
  std::vector<std::uint32_t> new_index(mesh.positions.size(), kUnused);
  for (const std::uint32_t index : mesh.indices) new_index[index] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t& index : new_index) {
    if (index != kUnused) index = count++;
  }
  if (count == mesh.positions.size()) return;
  keep(mesh.positions, new_index, count);
  keep(mesh.normals, new_index, count);
  keep(mesh.texcoords, new_index, count);
  keep(mesh.colours, new_index, count);
  for (std::uint32_t& index : mesh.indices) index = new_index[index];
}

/// Makes normals unit length. @return false if one has no direction
bool normalize_all(std::vector<glm::vec3>& normals) {
  bool all_good = true;
  for (glm::vec3& normal : normals) {
    const glm::dvec3 wide(normal);
    const double length = glm::length(wide);
    const bool good = length > 1e-20 && std::isfinite(length);
    normal = good ? glm::vec3(wide / length) : glm::vec3(0.0f);
    all_good = all_good && good;
  }
  return all_good;
}

void finish_normals(Mesh& mesh) {
  if (mesh.normals.size() != mesh.positions.size()) {
    mesh.normals.clear();
    compute_crease_normals(mesh, kCreaseRad);
    return;
  }
  if (normalize_all(mesh.normals)) return;
  // Only those without a direction are replaced.
  Mesh computed;
  computed.positions = mesh.positions;
  computed.indices = mesh.indices;
  compute_normals(computed);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (mesh.normals[i] == glm::vec3(0.0f)) mesh.normals[i] = computed.normals[i];
  }
}

template <typename T>
void zero_what_is_not_finite(std::vector<T>& values) {
  for (T& value : values) {
    for (int i = 0; i < T::length(); ++i) {
      if (!std::isfinite(value[i])) value[i] = 0.0f;
    }
  }
}

}  // namespace

void finish(Scene& scene, const ModelFile& file) {
  std::size_t dropped = 0;
  for (Mesh& mesh : scene.meshes) {
    dropped += drop_unusable_triangles(mesh);
    drop_unused_vertices(mesh);
    finish_normals(mesh);
    zero_what_is_not_finite(mesh.texcoords);
    zero_what_is_not_finite(mesh.colours);
  }
  if (dropped != 0) {
    file.warn("left out " + std::to_string(dropped) + (dropped == 1 ? " triangle" : " triangles") +
              " with a vertex that is not a finite number");
  }
  if (drawn_triangle_count(scene) == 0) file.fail("the model has no triangles");
}

}  // namespace kinescope
