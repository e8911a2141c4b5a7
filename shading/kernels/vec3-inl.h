// Three-component vectors, one a lane.
#if defined(KINESCOPE_SHADING_KERNELS_VEC3_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_SHADING_KERNELS_VEC3_INL_H
#undef KINESCOPE_SHADING_KERNELS_VEC3_INL_H
#else
#define KINESCOPE_SHADING_KERNELS_VEC3_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <glm/vec3.hpp>

#include "shading/kernels/fast_math-inl.h"
#include "shading/limits.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

using Floats = hn::ScalableTag<float>;
using Vec = hn::Vec<Floats>;

struct Vec3 {
  Vec x, y, z;
};

HWY_INLINE Vec3 splat(glm::vec3 v) {
  const Floats d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}
HWY_INLINE Vec3 load(const std::array<const float*, 3>& arrays, int i) {
  const Floats d;
  return {hn::Load(d, arrays[0] + i), hn::Load(d, arrays[1] + i), hn::Load(d, arrays[2] + i)};
}
HWY_INLINE Vec3 add(const Vec3& a, const Vec3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec3 sub(const Vec3& a, const Vec3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 mul(const Vec3& a, const Vec3& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE Vec3 mul_add(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {hn::MulAdd(a.x, b.x, c.x), hn::MulAdd(a.y, b.y, c.y), hn::MulAdd(a.z, b.z, c.z)};
}
HWY_INLINE Vec3 mul_add(const Vec& a, const Vec3& b, const Vec3& c) {
  return {hn::MulAdd(a, b.x, c.x), hn::MulAdd(a, b.y, c.y), hn::MulAdd(a, b.z, c.z)};
}
HWY_INLINE Vec3 scale(const Vec3& a, const Vec& s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Vec dot(const Vec3& a, const Vec3& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
/// 1 / |v| from |v|^2; finite where v has no direction.
HWY_INLINE Vec inverse_length(const Vec& squared) {
  const Floats d;
  return fast_rsqrt(d, hn::Max(squared, hn::Set(d, kLeastSquaredLength)));
}
HWY_INLINE Vec3 unit(const Vec3& v) { return scale(v, inverse_length(dot(v, v))); }

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#endif
