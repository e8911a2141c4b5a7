// Meshes at their places in the world, kept from frame to frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/framing.h"
#include "engine/scene.h"
#include "engine/vertex_transform.h"
#include "raster/base/workers.h"

namespace kinescope {

/// One mesh as one node shows it: what does not depend on the camera.
struct WorldMesh {
  const Mesh* mesh = nullptr;     ///< null: nothing to draw
  std::uint64_t fingerprint = 0;  ///< changes with the mesh
  WorldTransform transform;
  Positions positions;
  std::vector<float> rows;  ///< vertex_row of each vertex, and room for what clipping adds
  int row_stride = 0;
  int row_count = 0;
  Bounds bounds;

  std::size_t vertices() const { return positions.count; }
  std::size_t triangles() const { return mesh->indices.size() / 3; }
};

/// Every (node, mesh) of a scene, in the order of drawing. A mesh is moved to world space again
/// only when its node has moved or the mesh is another one.
class WorldMeshes {
 public:
  /// @return how many vertices were moved
  std::uint64_t update(Workers& workers, const Scene& scene);
  std::span<WorldMesh> items() { return items_; }
  /// Forgets everything, as after a mesh was changed in place.
  void invalidate() { keys_.clear(); }

 private:
  struct Key {
    std::uint64_t mesh = 0;  ///< fingerprint
    glm::mat4 world_from_local{0.0f};
    bool operator==(const Key&) const = default;
  };
  std::vector<WorldMesh> items_;
  std::vector<Key> keys_;
};

}  // namespace kinescope
