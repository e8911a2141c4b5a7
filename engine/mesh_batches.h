// Work on many meshes, shared out in batches of a fixed size.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/frame_mesh.h"

namespace kinescope {

/// Elements [begin, end) of one mesh.
struct MeshBatch {
  FrameMesh* mesh;
  std::size_t begin, end;
};

/// Cuts count_of(mesh) elements of each seen mesh into batches.
template <typename CountOf>
std::vector<MeshBatch> batches_of(std::span<FrameMesh> meshes, std::size_t size, CountOf count_of) {
  std::vector<MeshBatch> batches;
  for (FrameMesh& mesh : meshes) {
    if (!mesh.seen) continue;
    const std::size_t count = count_of(mesh);
    for (std::size_t begin = 0; begin < count; begin += size) {
      batches.push_back({&mesh, begin, std::min(count, begin + size)});
    }
  }
  return batches;
}

}  // namespace kinescope
