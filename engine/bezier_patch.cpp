#include "engine/bezier_patch.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace kinescope {
namespace {

using Vec = glm::dvec3;
using Weights = std::array<double, 4>;

/// Cubic Bernstein polynomials and their derivatives.
Weights bernstein(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}
Weights bernstein_slope(double t) {
  const double s = 1.0 - t;
  return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

Vec blend(const BezierPatch& patch, const Weights& in_u, const Weights& in_v) {
  Vec sum(0.0);
  for (std::size_t row = 0; row < 4; ++row) {
    const auto& p = patch.point[row];
    sum += in_v[row] * (in_u[0] * p[0] + in_u[1] * p[1] + in_u[2] * p[2] + in_u[3] * p[3]);
  }
  return sum;
}

/// The direction of a x b, unless they are parallel or one of them is negligible beside `scale`.
std::optional<Vec> direction_across(const Vec& a, const Vec& b, double scale) {
  const Vec across = glm::cross(a, b);
  const double length = glm::length(across);
  if (!(length > 1e-9 * scale * scale)) return std::nullopt;
  return across / length;
}

/// Where du vanishes, it vanishes as v nears the pole, and grows again by the mixed derivative: so
/// du points along +duv just inside v = 0 and along -duv just inside v = 1. Likewise dv.
Vec normal_of(const BezierPatch& patch, double u, double v, const Vec& du, const Vec& dv) {
  const Vec duv = blend(patch, bernstein_slope(u), bernstein_slope(v));
  const double scale = glm::length(du) + glm::length(dv) + glm::length(duv);
  if (const auto n = direction_across(du, dv, scale)) return *n;
  if (const auto n = direction_across(v < 0.5 ? duv : -duv, dv, scale)) return *n;
  if (const auto n = direction_across(du, u < 0.5 ? duv : -duv, scale)) return *n;
  // Both vanish: a step inside tells the limit nearly.
  const double step = 1e-4;
  const double u2 = u < 0.5 ? u + step : u - step, v2 = v < 0.5 ? v + step : v - step;
  const Vec du2 = blend(patch, bernstein_slope(u2), bernstein(v2));
  const Vec dv2 = blend(patch, bernstein(u2), bernstein_slope(v2));
  return direction_across(du2, dv2, glm::length(du2) + glm::length(dv2)).value_or(Vec(0.0));
}

}  // namespace

PatchSample sample_patch(const BezierPatch& patch, double u, double v) {
  PatchSample s;
  s.position = blend(patch, bernstein(u), bernstein(v));
  s.du = blend(patch, bernstein_slope(u), bernstein(v));
  s.dv = blend(patch, bernstein(u), bernstein_slope(v));
  s.normal = normal_of(patch, u, v, s.du, s.dv);
  return s;
}

void tessellate_patch(const BezierPatch& patch, int fineness, const PatchTexcoords& texcoords,
                      Mesh& mesh) {
  assert(fineness >= 1);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int row = 0; row <= fineness; ++row) {
    for (int column = 0; column <= fineness; ++column) {
      const double u = static_cast<double>(column) / fineness;
      const double v = static_cast<double>(row) / fineness;
      const PatchSample s = sample_patch(patch, u, v);
      mesh.positions.emplace_back(s.position);
      mesh.normals.emplace_back(s.normal);
      mesh.texcoords.push_back(texcoords.at_00 + glm::vec2(u, v) * texcoords.size);
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh.positions;
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) {
      mesh.indices.insert(mesh.indices.end(), {a, b, c});
    }
  };
  const auto stride = static_cast<std::uint32_t>(fineness) + 1;
  for (std::uint32_t row = 0; row + 1 < stride; ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t a = first + row * stride + column;
      add(a, a + 1, a + stride + 1);
      add(a, a + stride + 1, a + stride);
    }
  }
}

}  // namespace kinescope
