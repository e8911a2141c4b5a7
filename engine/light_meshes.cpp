#include <array>
#include <glm/geometric.hpp>

#include "engine/frame_mesh.h"
#include "engine/mesh_batches.h"

namespace kinescope {
namespace {

constexpr std::size_t kBatchVertices = 1024;
constexpr std::size_t kBatchTriangles = 256;

glm::vec3 load(const float* p) { return {p[0], p[1], p[2]}; }
void store(glm::vec3 v, float* p) {
  p[0] = v.x;
  p[1] = v.y;
  p[2] = v.z;
}

/// The row of a triangle: its centroid, its plane's normal, its mean colour.
void triangle_row(const WorldMesh& world, std::size_t triangle, float* out) {
  const auto stride = static_cast<std::size_t>(world.row_stride);
  const std::uint32_t* corner = &world.mesh->indices[triangle * 3];
  const float* a = &world.rows[corner[0] * stride];
  const float* b = &world.rows[corner[1] * stride];
  const float* c = &world.rows[corner[2] * stride];
  constexpr float kThird = 1.0f / 3.0f;
  for (std::size_t i = 0; i < stride; ++i) out[i] = (a[i] + b[i] + c[i]) * kThird;
  const glm::dvec3 origin(load(a));
  const glm::dvec3 normal = glm::cross(glm::dvec3(load(b)) - origin, glm::dvec3(load(c)) - origin);
  const double length = glm::length(normal) * (world.transform.mirrors ? -1.0 : 1.0);
  const bool usable = length != 0.0;
  store(usable ? glm::vec3(normal / length) : glm::vec3(0.0f), out + vertex_row::kNormal);
}

void light_triangles(const MeshBatch& batch) {
  const WorldMesh& world = *batch.mesh->world;
  const auto stride = static_cast<std::size_t>(world.row_stride);
  const std::size_t count = batch.end - batch.begin;
  alignas(64) std::array<float, kBatchTriangles * vertex_row::kStrideWithColour> rows;
  alignas(64) std::array<float, kBatchTriangles * lit_row::kMaxSize> lit;
  const bool apart = keeps_highlight_apart(batch.mesh->surface);
  const auto lit_size = static_cast<std::size_t>(lit_row_size(batch.mesh->surface));
  for (std::size_t i = 0; i < count; ++i) triangle_row(world, batch.begin + i, &rows[i * stride]);
  light_vertices(batch.mesh->surface, std::span(rows).first(count * stride),
                 std::span(lit).first(count * lit_size));
  for (std::size_t i = 0; i < count; ++i) {
    const float* row = &lit[i * lit_size];
    batch.mesh->triangle_light[batch.begin + i] = {
        load(row + lit_row::kBody), apart ? load(row + lit_row::kHighlight) : glm::vec3(0.0f)};
  }
}

}  // namespace

void light_mesh_vertices(Workers& workers, std::span<FrameMesh> meshes) {
  const auto vertices = [](const FrameMesh& mesh) { return mesh.world->vertices(); };
  const std::vector<MeshBatch> batches = batches_of(meshes, kBatchVertices, vertices);
  for (FrameMesh& mesh : meshes) {
    if (!mesh.seen) continue;
    mesh.lit_rows.resize(mesh.world->vertices() *
                         static_cast<std::size_t>(lit_row_size(mesh.surface)));
  }
  workers.run(static_cast<int>(batches.size()), [&](int task, int) {
    const MeshBatch& batch = batches[static_cast<std::size_t>(task)];
    const WorldMesh& world = *batch.mesh->world;
    const auto stride = static_cast<std::size_t>(world.row_stride);
    const auto lit_size = static_cast<std::size_t>(lit_row_size(batch.mesh->surface));
    const std::size_t count = batch.end - batch.begin;
    const std::span<const float> rows = std::span(world.rows).subspan(batch.begin * stride);
    light_vertices(
        batch.mesh->surface, rows.first(count * stride),
        std::span(batch.mesh->lit_rows).subspan(batch.begin * lit_size, count * lit_size));
  });
}

void light_mesh_triangles(Workers& workers, std::span<FrameMesh> meshes) {
  const auto triangles = [](const FrameMesh& mesh) { return mesh.world->triangles(); };
  const std::vector<MeshBatch> batches = batches_of(meshes, kBatchTriangles, triangles);
  for (FrameMesh& mesh : meshes) {
    if (!mesh.seen) continue;
    mesh.triangle_light.resize(mesh.world->triangles());
    mesh.surface.triangle_light = mesh.triangle_light;
  }
  workers.run(static_cast<int>(batches.size()),
              [&](int task, int) { light_triangles(batches[static_cast<std::size_t>(task)]); });
}

}  // namespace kinescope
