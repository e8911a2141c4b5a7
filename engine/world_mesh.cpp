#include "engine/world_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/normals.h"
#include "shading/surface.h"

namespace kinescope {
namespace {

constexpr std::size_t kTaskVertices = 4096;

void mix(std::uint64_t& hash, std::uint64_t value) {
  hash = (std::rotl(hash, 23) ^ value) * 0x9e3779b97f4a7c15u;
}

template <typename T>
void mix_array(std::uint64_t& hash, const std::vector<T>& array) {
  mix(hash, std::bit_cast<std::uintptr_t>(array.data()));
  mix(hash, array.size());
  // A few samples tell a new mesh from an old one that lay in the same memory.
  const std::size_t step = std::max<std::size_t>(1, array.size() / 8);
  for (std::size_t i = 0; i < array.size(); i += step) {
    std::array<std::uint32_t, sizeof(T) / 4> words{};
    std::memcpy(words.data(), &array[i], sizeof(T));
    for (const std::uint32_t word : words) mix(hash, word);
  }
}

std::uint64_t fingerprint(const Mesh& mesh) {
  std::uint64_t hash = 1;
  mix_array(hash, mesh.positions);
  mix_array(hash, mesh.normals);
  mix_array(hash, mesh.texcoords);
  mix_array(hash, mesh.colours);
  mix_array(hash, mesh.indices);
  return hash;
}

bool drawable(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  const auto fits = [count](std::size_t n) { return n == 0 || n == count; };
  return mesh.indices.size() >= 3 && fits(mesh.texcoords.size()) && fits(mesh.colours.size()) &&
         *std::max_element(mesh.indices.begin(), mesh.indices.end()) < count;
}

void fill_unmoved(const Mesh& mesh, std::size_t begin, std::size_t end, WorldMesh& item) {
  for (std::size_t i = begin; i < end; ++i) {
    float* row = &item.rows[i * static_cast<std::size_t>(item.row_stride)];
    const glm::vec2 uv = mesh.texcoords.empty() ? glm::vec2(0.0f) : mesh.texcoords[i];
    row[vertex_row::kTexcoord] = uv.x;
    row[vertex_row::kTexcoord + 1] = uv.y;
    if (mesh.colours.empty()) continue;
    for (int c = 0; c < 3; ++c) row[vertex_row::kColour + c] = mesh.colours[i][c];
  }
}

Bounds bounds_of(const Positions& p, std::size_t begin, std::size_t end) {
  Bounds bounds;
  for (std::size_t i = begin; i < end; ++i) bounds.add({p.x[i], p.y[i], p.z[i]});
  return bounds;
}

void move_mesh(Workers& workers, const Mesh& mesh, const glm::mat4& world_from_local,
               WorldMesh& item) {
  item.mesh = drawable(mesh) ? &mesh : nullptr;
  item.bounds = {};
  if (item.mesh == nullptr) return;
  Mesh with_normals;
  std::span<const glm::vec3> normals = mesh.normals;
  if (normals.size() != mesh.positions.size()) {
    with_normals.positions = mesh.positions;
    with_normals.indices = mesh.indices;
    compute_normals(with_normals);
    normals = with_normals.normals;
  }
  const bool coloured = !mesh.colours.empty();
  item.row_stride = coloured ? vertex_row::kStrideWithColour : vertex_row::kStride;
  item.row_count = coloured ? vertex_row::kCountWithColour : vertex_row::kCount;
  item.transform = make_world_transform(world_from_local);
  const std::size_t count = mesh.positions.size();
  item.positions.resize(count);
  item.rows.resize(count * static_cast<std::size_t>(item.row_stride));
  const std::size_t tasks = (count + kTaskVertices - 1) / kTaskVertices;
  std::vector<Bounds> bounds(tasks);
  workers.run(static_cast<int>(tasks), [&](int task, int) {
    const auto t = static_cast<std::size_t>(task);
    const std::size_t begin = t * kTaskVertices, end = std::min(count, begin + kTaskVertices);
    to_world(item.transform, mesh.positions, normals, begin, end, item.positions, item.rows,
             item.row_stride);
    fill_unmoved(mesh, begin, end, item);
    bounds[t] = bounds_of(item.positions, begin, end);
  });
  for (const Bounds& part : bounds) item.bounds.add(part);
}

}  // namespace

std::uint64_t WorldMeshes::update(Workers& workers, const Scene& scene) {
  const std::vector<glm::mat4> world_from_local = world_transforms(scene);
  std::vector<std::uint64_t> fingerprints;
  for (const Mesh& mesh : scene.meshes) fingerprints.push_back(fingerprint(mesh));
  std::uint64_t moved = 0;
  std::size_t slot = 0;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    for (const int index : scene.nodes[n].meshes) {
      if (index < 0 || static_cast<std::size_t>(index) >= scene.meshes.size()) continue;
      const auto m = static_cast<std::size_t>(index);
      if (items_.size() <= slot) items_.emplace_back();
      if (keys_.size() <= slot) keys_.emplace_back();
      WorldMesh& item = items_[slot];
      const Key key{fingerprints[m], world_from_local[n]};
      if (keys_[slot] != key) {
        keys_[slot] = {};
        move_mesh(workers, scene.meshes[m], world_from_local[n], item);
        keys_[slot] = key;
        item.fingerprint = key.mesh;
        moved += item.vertices();
      }
      // The scene may have been copied or grown since.
      if (item.mesh != nullptr) item.mesh = &scene.meshes[m];
      ++slot;
    }
  }
  items_.resize(slot);
  keys_.resize(slot);
  return moved;
}

}  // namespace kinescope
