// Which class of transformations a matrix belongs to.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace kinescope {

/// Each class lies in the ones after it, up to kProjective: an identity is rigid too.
enum class TransformClass {
  kIdentity,
  kTranslation,
  kRigid,       ///< lengths, angles and handedness stay
  kIsometry,    ///< lengths and angles stay, handedness turns: reflections
  kConformal,   ///< angles stay, lengths by one factor
  kAffine,      ///< parallels stay parallel
  kProjective,  ///< straight lines stay straight
  kSingular,    ///< no inverse: what it flattens cannot be had back
  kNotFinite,
};

/// The smallest class that holds the matrix, entries told apart down to `tolerance` of the largest.
TransformClass transform_class(const glm::dmat3& matrix, double tolerance = 1e-12);
TransformClass transform_class(const glm::dmat4& matrix, double tolerance = 1e-12);

const char* class_name(TransformClass c);

/// The nesting, as questions.
bool is_rigid(TransformClass c);
bool is_conformal(TransformClass c);
bool is_affine(TransformClass c);

}  // namespace kinescope
