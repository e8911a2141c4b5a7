#include <glm/vec4.hpp>

#include "engine/frame_mesh.h"
#include "engine/mesh_batches.h"

namespace kinescope {
namespace {

constexpr std::size_t kBatchVertices = 4096;

}  // namespace

bool outside_view(const glm::mat4& clip_from_world, const Bounds& bounds) {
  if (bounds.empty) return true;
  const std::array<ClipPlane, 6> planes = view_volume_planes();
  const glm::dmat4 clip(clip_from_world);
  // A plane's distance is linear over the box, so its corners decide.
  return std::any_of(planes.begin(), planes.end(), [&](const ClipPlane& plane) {
    for (int i = 0; i < 8; ++i) {
      const glm::dvec4 corner((i & 1) ? bounds.max.x : bounds.min.x,
                              (i & 2) ? bounds.max.y : bounds.min.y,
                              (i & 4) ? bounds.max.z : bounds.min.z, 1.0);
      if (!(plane.inside_by(clip * corner) < 0.0)) return false;
    }
    return true;
  });
}

std::uint64_t project_meshes(Workers& workers, const Projector& projector,
                             std::span<FrameMesh> meshes) {
  const auto vertices = [](const FrameMesh& mesh) { return mesh.world->vertices(); };
  const std::vector<MeshBatch> batches = batches_of(meshes, kBatchVertices, vertices);
  for (FrameMesh& mesh : meshes) {
    if (mesh.seen) mesh.device.resize(mesh.world->vertices() + Positions::kPadding);
  }
  std::vector<OutcodeSummary> summaries(batches.size());
  workers.run(static_cast<int>(batches.size()), [&](int task, int) {
    const auto t = static_cast<std::size_t>(task);
    const MeshBatch& batch = batches[t];
    summaries[t] = project(projector, batch.mesh->world->positions, batch.begin, batch.end,
                           batch.mesh->device);
  });
  for (FrameMesh& mesh : meshes) mesh.outcodes = {};
  std::uint64_t projected = 0;
  for (std::size_t t = 0; t < batches.size(); ++t) {
    OutcodeSummary& sum = batches[t].mesh->outcodes;
    sum.any |= summaries[t].any;
    sum.all &= summaries[t].all;
    projected += batches[t].end - batches[t].begin;
  }
  for (FrameMesh& mesh : meshes) {
    if ((mesh.outcodes.all & outcode::kVolume) != 0) mesh.seen = false;
  }
  return projected;
}

}  // namespace kinescope
