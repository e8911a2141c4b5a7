// A scene as points, faces and edges: what a wireframe of strokes is made of.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene.h"

namespace kinescope {

/// Two faces at most meet at an edge of a surface; at others, as at a border, it is always drawn.
struct WireEdge {
  static constexpr int kNone = -1;
  std::uint32_t a = 0, b = 0;              ///< points, a < b
  std::array<int, 2> faces{kNone, kNone};  ///< that it lies between
  /// By how much the surface turns there, radians: 0 within a flat face, pi at a border.
  float bend_rad = 0;
};

struct WireScene {
  std::vector<glm::dvec3> points;                   ///< of the world, each place once
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< triangles with an area
  std::vector<WireEdge> edges;                      ///< each once, in ascending order of points
};

/// All that a scene draws. Corners at one place are one point, whatever their normals and meshes.
/// Triangles with a corner that is not finite, or farther out than 1e18, are left out; of those
/// without an area there remain edges.
WireScene wire_scene(const Scene& scene);

}  // namespace kinescope
