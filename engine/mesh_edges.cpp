#include "engine/mesh_edges.h"

#include <algorithm>

namespace kinescope {

std::vector<Edge> unique_edges(std::span<const std::uint32_t> indices) {
  std::vector<Edge> edges;
  edges.reserve(indices.size());
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = indices[t + i], b = indices[t + (i + 1) % 3];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace kinescope
