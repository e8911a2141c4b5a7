#include "engine/figures/beams.h"

#include <cstdint>

namespace kinescope {

Mesh three_beams() {
  Mesh mesh;
  for (int beam = 0; beam < 3; ++beam) {
    glm::vec3 half(0.22f), middle(0);
    half[beam] = 1.1f;
    middle[(beam + 1) % 3] = 0.5f;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (unsigned i = 0; i < 8; ++i) {
      const glm::vec3 side((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      mesh.positions.push_back(middle + half * side);
    }
    for (const std::uint32_t i :
         {0u, 2u, 1u, 1u, 2u, 3u, 4u, 5u, 6u, 5u, 7u, 6u, 0u, 1u, 4u, 1u, 5u, 4u,
          2u, 6u, 3u, 3u, 6u, 7u, 0u, 4u, 2u, 2u, 4u, 6u, 1u, 3u, 5u, 3u, 7u, 5u}) {
      mesh.indices.push_back(first + i);
    }
  }
  return mesh;
}

}  // namespace kinescope
