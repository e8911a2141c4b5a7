// The edges of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace kinescope {

using Edge = std::array<std::uint32_t, 2>;

/// Every edge once, however many triangles share it: lower index first, in ascending order.
/// Edges between a vertex and itself are left out.
std::vector<Edge> unique_edges(std::span<const std::uint32_t> indices);

}  // namespace kinescope
