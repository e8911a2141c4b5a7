#include "raster/tile.h"

namespace kinescope {

void merge_fragments(const ChunkList<FragmentChunk>& fragments, TileBuffer& tile) {
  float* const depth = tile.depth.data();
  std::uint32_t* const id = tile.id.data();
  for (const FragmentChunk* chunk = fragments.first; chunk != nullptr; chunk = chunk->next) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk->size); ++i) {
      const std::uint32_t place = chunk->pixel[i];
      const float z = chunk->depth[0][i], old_z = depth[place];
      const std::uint32_t triangle = chunk->id[i];
      // Written either way: a store costs less than a branch that nobody can predict.
      const bool wins = (z < old_z) | ((z == old_z) & (triangle < id[place]));
      depth[place] = wins ? z : old_z;
      id[place] = wins ? triangle : id[place];
    }
  }
}

}  // namespace kinescope
