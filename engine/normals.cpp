#include "engine/normals.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace kinescope {
namespace {

// Double precision: squares of any float neither overflow nor vanish.
using Vec = glm::dvec3;

void add_triangle(const std::array<Vec, 3>& p, const std::array<std::uint32_t, 3>& corner,
                  std::vector<Vec>& sums) {
  const Vec normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double length = glm::length(normal);
  if (!(length > 0.0) || !std::isfinite(length)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec to_next = p[(i + 1) % 3] - p[i];
    const Vec to_last = p[(i + 2) % 3] - p[i];
    // Unlike acos of a scalar product, this is accurate for slivers too.
    const double angle = std::atan2(length, glm::dot(to_next, to_last));
    sums[corner[i]] += normal * (angle / length);
  }
}

}  // namespace

void compute_normals(Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  std::vector<Vec> sums(count, Vec(0.0));
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::array<std::uint32_t, 3> corner{mesh.indices[t], mesh.indices[t + 1],
                                              mesh.indices[t + 2]};
    if (corner[0] >= count || corner[1] >= count || corner[2] >= count) continue;
    add_triangle({Vec(mesh.positions[corner[0]]), Vec(mesh.positions[corner[1]]),
                  Vec(mesh.positions[corner[2]])},
                 corner, sums);
  }
  mesh.normals.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const double length = glm::length(sums[v]);
    // Sheets that meet back to back cancel out, up to rounding.
    mesh.normals[v] = length > 1e-9 ? glm::vec3(sums[v] / length) : glm::vec3(0.0f, 1.0f, 0.0f);
  }
}

}  // namespace kinescope
