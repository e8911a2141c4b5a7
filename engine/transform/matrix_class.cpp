#include "engine/transform/matrix_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace kinescope {
namespace {

template <int N, typename Matrix>
double largest_difference(const Matrix& a, const Matrix& b) {
  double largest = 0.0;
  for (int column = 0; column < N; ++column) {
    for (int row = 0; row < N; ++row) {
      largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    }
  }
  return largest;
}

template <int N, typename Matrix>
bool all_finite(const Matrix& m) {
  for (int column = 0; column < N; ++column) {
    for (int row = 0; row < N; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

/// N counts homogeneous coordinates; the linear part is one smaller.
template <int N, typename Matrix, typename Linear>
TransformClass classify(Matrix m, double tolerance) {
  if (!all_finite<N>(m)) return TransformClass::kNotFinite;
  const double scale = largest_difference<N>(m, Matrix(0.0));
  if (scale == 0.0) return TransformClass::kSingular;
  const double w = m[N - 1][N - 1];
  double perspective = 0.0;
  for (int column = 0; column + 1 < N; ++column) {
    perspective = std::max(perspective, std::abs(m[column][N - 1]));
  }
  if (perspective > tolerance * std::abs(w) || w == 0.0) {
    const double determinant = glm::determinant(m / scale);
    return std::abs(determinant) > tolerance ? TransformClass::kProjective
                                             : TransformClass::kSingular;
  }
  m = m / w;  // the same transformation
  const Linear linear(m);
  const double extent = largest_difference<N - 1>(linear, Linear(0.0));
  if (extent == 0.0 || std::abs(glm::determinant(linear / extent)) <= tolerance) {
    return TransformClass::kSingular;
  }
  const Linear even = linear / extent;  // whose squares neither overflow nor vanish
  const Linear gram = glm::transpose(even) * even;
  const double square = gram[0][0];
  if (largest_difference<N - 1>(gram, Linear(square)) > tolerance * square) {
    return TransformClass::kAffine;
  }
  if (std::abs(square * extent * extent - 1.0) > tolerance) return TransformClass::kConformal;
  if (glm::determinant(linear) < 0.0) return TransformClass::kIsometry;
  if (largest_difference<N - 1>(linear, Linear(1.0)) > tolerance) return TransformClass::kRigid;
  double moved = 0.0;
  for (int row = 0; row + 1 < N; ++row) moved = std::max(moved, std::abs(m[N - 1][row]));
  return moved == 0.0 ? TransformClass::kIdentity : TransformClass::kTranslation;
}

}  // namespace

TransformClass transform_class(const glm::dmat3& matrix, double tolerance) {
  return classify<3, glm::dmat3, glm::dmat2>(matrix, tolerance);
}

TransformClass transform_class(const glm::dmat4& matrix, double tolerance) {
  return classify<4, glm::dmat4, glm::dmat3>(matrix, tolerance);
}

const char* class_name(TransformClass c) {
  constexpr std::array kNames = {"identity", "translation", "rigid",    "isometry",  "conformal",
                                 "affine",   "projective",  "singular", "not finite"};
  return kNames[static_cast<std::size_t>(c)];
}

bool is_rigid(TransformClass c) { return c <= TransformClass::kRigid; }
bool is_conformal(TransformClass c) { return c <= TransformClass::kConformal; }
bool is_affine(TransformClass c) { return c <= TransformClass::kAffine; }

}  // namespace kinescope
