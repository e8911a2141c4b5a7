// Sierpinski's tetrahedron as an observer sees it from afar: turned, and sorted for the painter.
#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "engine/fractals/gasket.h"

namespace kinescope {

using Triangle3 = std::array<glm::dvec3, 3>;

/// The pieces of a regular tetrahedron about the origin, its corners at distance 1, one of them up.
/// Turned about y, then seen from above: z is nearness, far pieces come first.
std::vector<Tetrahedron> seen_tetrahedra(int generations, double turn_deg, double tilt_deg);

/// Calls sink(face, corners) for the faces that look towards +z; face 0 is the lowest.
template <typename Sink>
void faces_seen(const Tetrahedron& t, Sink&& sink) {
  constexpr std::size_t kFaces[4][3] = {{1, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  const glm::dvec3 middle = (t[0] + t[1] + t[2] + t[3]) * 0.25;
  for (std::size_t face = 0; face < 4; ++face) {
    const Triangle3 c = {t[kFaces[face][0]], t[kFaces[face][1]], t[kFaces[face][2]]};
    const glm::dvec3 across = glm::cross(c[1] - c[0], c[2] - c[0]);
    const bool outwards = glm::dot(across, c[0] - middle) > 0.0;
    if ((across.z > 0.0) == outwards) sink(face, c);
  }
}

}  // namespace kinescope
