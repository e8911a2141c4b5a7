#include "engine/transform/in_between.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "engine/transform/transform3d.h"

namespace kinescope {
namespace {

constexpr double kRounding = 1e-9;

bool is_rotation(const glm::dmat3& m) {
  const glm::dmat3 square = m * glm::transpose(m);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(square[i][j] - (i == j ? 1.0 : 0.0)) < kRounding)) return false;
    }
  }
  return glm::determinant(m) > 0.0;
}

/// Along the axis, twice the sine of the angle long.
glm::dvec3 twice_the_sine(const glm::dmat3& m) {
  return {m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]};
}

/// Of half turns, whose sine is 0: the longest column of m + 1.
glm::dvec3 axis_of_half_turn(const glm::dmat3& m) {
  const glm::dmat3 both = m + glm::dmat3(1.0);
  glm::dvec3 longest(0.0);
  for (int i = 0; i < 3; ++i) {
    if (glm::length(both[i]) > glm::length(longest)) longest = both[i];
  }
  return longest;
}

}  // namespace

glm::dmat4 in_between(const glm::dmat4& affine, double share) {
  if (share == 0.0) return glm::dmat4(1.0);
  if (share == 1.0) return affine;
  const glm::dmat3 linear(affine);
  glm::dmat4 part = (1.0 - share) * glm::dmat4(1.0) + share * affine;
  if (linear == glm::dmat3(1.0) || !is_rotation(linear)) return part;
  const glm::dvec3 sine = twice_the_sine(linear);
  const double length = glm::length(sine);
  const glm::dvec3 axis = length > kRounding ? sine : axis_of_half_turn(linear);
  const double cosine = linear[0][0] + linear[1][1] + linear[2][2] - 1.0;  // twice
  const double angle_deg = std::atan2(length, cosine) * (180.0 / std::numbers::pi);
  const glm::dvec4 moved = part[3];
  part = rotation_about_deg({{}, axis}, share * angle_deg);
  part[3] = moved;
  return part;
}

}  // namespace kinescope
