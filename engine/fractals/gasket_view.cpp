#include "engine/fractals/gasket_view.h"

#include <algorithm>
#include <cmath>

#include "engine/transform/exact_angle.h"

namespace kinescope {

std::vector<Tetrahedron> seen_tetrahedra(int generations, double turn_deg, double tilt_deg) {
  const auto [s, c] = sine_cosine_deg(turn_deg);
  const auto [up, out] = sine_cosine_deg(tilt_deg);
  const auto seen = [&](const glm::dvec3& p) {
    const double z = c * p.z - s * p.x;
    return glm::dvec3(c * p.x + s * p.z, out * p.y - up * z, out * z + up * p.y);
  };
  const double r = std::sqrt(8.0) / 3, h = std::sqrt(3.0) / 2 * r;
  std::vector<Tetrahedron> pieces;
  sierpinski_tetrahedron(
      {{{0, 1, 0}, {r, -1.0 / 3, 0}, {-r / 2, -1.0 / 3, h}, {-r / 2, -1.0 / 3, -h}}}, generations,
      [&](const Tetrahedron& t) {
        pieces.push_back({seen(t[0]), seen(t[1]), seen(t[2]), seen(t[3])});
      });
  const auto nearness = [](const Tetrahedron& t) { return t[0].z + t[1].z + t[2].z + t[3].z; };
  std::stable_sort(pieces.begin(), pieces.end(), [&](const Tetrahedron& a, const Tetrahedron& b) {
    return nearness(a) < nearness(b);
  });
  return pieces;
}

}  // namespace kinescope
